#include "studies/picture/rendering.h"

#include <cairo-pdf.h>
#include <cairo.h>
#include <fmt/format.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <memory>

#include "engine/base/error.h"

namespace gurney::picture {
namespace {

constexpr double kPointsPerInch = 72, kPixelsPerInch = 300;
constexpr double kLargestSide = 32767;  // on a side, of cairo's images

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

Surface owned(cairo_surface_t* surface) { return {surface, cairo_surface_destroy}; }

void check(cairo_status_t status) {
  require(status == CAIRO_STATUS_SUCCESS,
          fmt::format("cannot draw the figure: {}", cairo_status_to_string(status)));
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

void check(gboolean done, GError* error) {
  if (done != FALSE) return;
  const std::string reason = error != nullptr ? error->message : "unknown";
  g_clear_error(&error);
  throw Error("cannot draw the figure: " + reason);
}

/// Fills a surface of this size in its own unit.
void draw(const std::string& svg, cairo_surface_t* surface, double width, double height) {
  check(cairo_surface_status(surface));
  GError* error = nullptr;
  const std::unique_ptr<GInputStream, decltype(&g_object_unref)> stream(
      g_memory_input_stream_new_from_data(svg.data(), static_cast<gssize>(svg.size()), nullptr),
      g_object_unref);
  const std::unique_ptr<RsvgHandle, decltype(&g_object_unref)> handle(
      rsvg_handle_new_from_stream_sync(stream.get(), nullptr, RSVG_HANDLE_FLAG_UNLIMITED, nullptr,
                                       &error),
      g_object_unref);
  check(handle ? TRUE : FALSE, error);
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context(cairo_create(surface),
                                                                   cairo_destroy);
  const RsvgRectangle whole{0, 0, width, height};
  check(rsvg_handle_render_document(handle.get(), context.get(), &whole, &error), error);
  check(cairo_status(context.get()));
}

}  // namespace

std::string pdf(const std::string& svg, const Size& size) {
  std::string bytes;
  const double width = size.width * kPointsPerInch, height = size.height * kPointsPerInch;
  {
    const Surface surface =
        owned(cairo_pdf_surface_create_for_stream(append, &bytes, width, height));
    // No date: the same figure gives the same bytes.
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
    draw(svg, surface.get(), width, height);
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
  }
  return bytes;
}

std::string png(const std::string& svg, const Size& size) {
  const double width = std::round(size.width * kPixelsPerInch),
               height = std::round(size.height * kPixelsPerInch);
  require(width <= kLargestSide && height <= kLargestSide,
          fmt::format("the figure would have {:.0f} x {:.0f} pixels, and at most {:.0f} can be "
                      "drawn; choose a smaller width, or .pdf or .svg",
                      width, height, kLargestSide));
  const Surface surface = owned(cairo_image_surface_create(
      CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)));
  {
    const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> paper(cairo_create(surface.get()),
                                                                   cairo_destroy);
    cairo_set_source_rgb(paper.get(), 1, 1, 1);  // edges that end inside a pixel mix with it
    cairo_paint(paper.get());
  }
  draw(svg, surface.get(), width, height);
  std::string bytes;
  check(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
  return bytes;
}

}  // namespace gurney::picture
