#include "studies/playback/page.h"

#include <string_view>

#include "embedded/camera_js.h"
#include "embedded/graph_js.h"
#include "embedded/meshes_js.h"
#include "embedded/page_html.h"
#include "embedded/playback_css.h"
#include "embedded/player_js.h"
#include "embedded/recording_js.h"
#include "embedded/renderer_js.h"
#include "embedded/room_js.h"
#include "embedded/saving_js.h"
#include "embedded/shaders_js.h"
#include "embedded/vectors_js.h"
#include "embedded/widgets_js.h"

namespace gurney::playback {
namespace {

void replace(std::string& text, std::string_view mark, std::string_view by) {
  const auto place = text.find(mark);
  text.replace(place, mark.size(), by);
}

}  // namespace

std::string playback_page(const std::vector<PageRun>& runs, const std::vector<PageRun>& ghosts) {
  std::string script;
  for (const std::string_view part :
       {embedded::vectors_js, embedded::recording_js, embedded::meshes_js, embedded::shaders_js,
        embedded::renderer_js, embedded::camera_js, embedded::room_js, embedded::graph_js,
        embedded::widgets_js, embedded::saving_js, embedded::player_js})
    script += part;
  std::string page(embedded::page_html);
  replace(page, "/*STYLE*/", embedded::playback_css);
  replace(page, "/*SCRIPT*/", script);
  replace(page, "/*DATA*/", page_data(runs, ghosts));
  return page;
}

}  // namespace gurney::playback
