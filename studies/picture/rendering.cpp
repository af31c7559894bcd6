#include "studies/picture/rendering.h"

#include <cairo-pdf.h>
#include <cairo.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <memory>

#include "engine/base/error.h"

namespace gurney::picture {
namespace {

constexpr double kPointsPerInch = 72, kPixelsPerInch = 300;
constexpr double kLargestSide = 32767;  // on a side, of cairo's images

/// librsvg with what it uses, cairo and GLib. Loaded when the first picture is drawn: these 40
/// libraries would double the time in which the program starts, and each of its processes would
/// keep their memory.
class Library {
 public:
  const decltype(&::cairo_create) cairo_create = find<decltype(&::cairo_create)>("cairo_create");
  const decltype(&::cairo_destroy) cairo_destroy =
      find<decltype(&::cairo_destroy)>("cairo_destroy");
  const decltype(&::cairo_image_surface_create) cairo_image_surface_create =
      find<decltype(&::cairo_image_surface_create)>("cairo_image_surface_create");
  const decltype(&::cairo_paint) cairo_paint = find<decltype(&::cairo_paint)>("cairo_paint");
  const decltype(&::cairo_pdf_surface_create_for_stream) cairo_pdf_surface_create_for_stream =
      find<decltype(&::cairo_pdf_surface_create_for_stream)>("cairo_pdf_surface_create_for_stream");
  const decltype(&::cairo_pdf_surface_set_metadata) cairo_pdf_surface_set_metadata =
      find<decltype(&::cairo_pdf_surface_set_metadata)>("cairo_pdf_surface_set_metadata");
  const decltype(&::cairo_set_source_rgb) cairo_set_source_rgb =
      find<decltype(&::cairo_set_source_rgb)>("cairo_set_source_rgb");
  const decltype(&::cairo_status) cairo_status = find<decltype(&::cairo_status)>("cairo_status");
  const decltype(&::cairo_status_to_string) cairo_status_to_string =
      find<decltype(&::cairo_status_to_string)>("cairo_status_to_string");
  const decltype(&::cairo_surface_destroy) cairo_surface_destroy =
      find<decltype(&::cairo_surface_destroy)>("cairo_surface_destroy");
  const decltype(&::cairo_surface_finish) cairo_surface_finish =
      find<decltype(&::cairo_surface_finish)>("cairo_surface_finish");
  const decltype(&::cairo_surface_status) cairo_surface_status =
      find<decltype(&::cairo_surface_status)>("cairo_surface_status");
  const decltype(&::cairo_surface_write_to_png_stream) cairo_surface_write_to_png_stream =
      find<decltype(&::cairo_surface_write_to_png_stream)>("cairo_surface_write_to_png_stream");
  const decltype(&::g_clear_error) g_clear_error =
      find<decltype(&::g_clear_error)>("g_clear_error");
  const decltype(&::g_memory_input_stream_new_from_data) g_memory_input_stream_new_from_data =
      find<decltype(&::g_memory_input_stream_new_from_data)>("g_memory_input_stream_new_from_data");
  const decltype(&::g_object_unref) g_object_unref =
      find<decltype(&::g_object_unref)>("g_object_unref");
  const decltype(&::rsvg_handle_new_from_stream_sync) rsvg_handle_new_from_stream_sync =
      find<decltype(&::rsvg_handle_new_from_stream_sync)>("rsvg_handle_new_from_stream_sync");
  const decltype(&::rsvg_handle_render_document) rsvg_handle_render_document =
      find<decltype(&::rsvg_handle_render_document)>("rsvg_handle_render_document");

 private:
  static constexpr const char* kFile = "librsvg-2.so.2";

  /// A function of the library or of one that it uses.
  template <class Function>
  static Function find(const char* name) {
    void* const library = dlopen(kFile, RTLD_NOW | RTLD_LOCAL);  // stays for good
    if (library == nullptr)
      throw Error(fmt::format("PDF and PNG need {} (Debian: librsvg2-2); .svg does not: {}", kFile,
                              dlerror()));
    void* const found = dlsym(library, name);
    require(found != nullptr, fmt::format("{} has no function {}", kFile, name));
    return reinterpret_cast<Function>(found);
  }
};

const Library& library() {
  static const Library loaded;
  return loaded;
}

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

Surface owned(cairo_surface_t* surface) { return {surface, library().cairo_surface_destroy}; }

void check(cairo_status_t status) {
  require(status == CAIRO_STATUS_SUCCESS,
          fmt::format("cannot draw the figure: {}", library().cairo_status_to_string(status)));
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

void check(gboolean done, GError* error) {
  if (done != FALSE) return;
  const std::string reason = error != nullptr ? error->message : "unknown";
  library().g_clear_error(&error);
  throw Error("cannot draw the figure: " + reason);
}

/// Fills a surface of this size in its own unit.
void draw(const std::string& svg, cairo_surface_t* surface, double width, double height) {
  check(library().cairo_surface_status(surface));
  GError* error = nullptr;
  const std::unique_ptr<GInputStream, decltype(&g_object_unref)> stream(
      library().g_memory_input_stream_new_from_data(svg.data(), static_cast<gssize>(svg.size()),
                                                    nullptr),
      library().g_object_unref);
  const std::unique_ptr<RsvgHandle, decltype(&g_object_unref)> handle(
      library().rsvg_handle_new_from_stream_sync(stream.get(), nullptr, RSVG_HANDLE_FLAG_UNLIMITED,
                                                 nullptr, &error),
      library().g_object_unref);
  check(handle ? TRUE : FALSE, error);
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context(library().cairo_create(surface),
                                                                   library().cairo_destroy);
  const RsvgRectangle whole{0, 0, width, height};
  check(library().rsvg_handle_render_document(handle.get(), context.get(), &whole, &error), error);
  check(library().cairo_status(context.get()));
}

}  // namespace

std::string pdf(const std::string& svg, const Size& size) {
  std::string bytes;
  const double width = size.width * kPointsPerInch, height = size.height * kPointsPerInch;
  {
    const Surface surface =
        owned(library().cairo_pdf_surface_create_for_stream(append, &bytes, width, height));
    // No date: the same figure gives the same bytes.
    library().cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
    draw(svg, surface.get(), width, height);
    library().cairo_surface_finish(surface.get());
    check(library().cairo_surface_status(surface.get()));
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
  const Surface surface = owned(library().cairo_image_surface_create(
      CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)));
  {
    const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> paper(
        library().cairo_create(surface.get()), library().cairo_destroy);
    library().cairo_set_source_rgb(paper.get(), 1, 1,
                                   1);  // edges that end inside a pixel mix with it
    library().cairo_paint(paper.get());
  }
  draw(svg, surface.get(), width, height);
  std::string bytes;
  check(library().cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
  return bytes;
}

}  // namespace gurney::picture
