#include "studies/picture/picture.h"

#include <cairo-pdf.h>
#include <cairo.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <librsvg/rsvg.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

#include "engine/base/error.h"
#include "engine/base/number_text.h"

namespace gurney::picture {
namespace {

constexpr double kPointsPerInch = 72, kPixelsPerInch = 300, kMmPerInch = 25.4, kPxPerInch = 96;
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

constexpr double kNarrowestMm = 20, kWidestMm = 1000;

/// The number of an attribute of the first tag: width="700".
double attribute_of(const std::string& svg, const std::string& name) {
  const std::string key = " " + name + "=\"";
  const auto at = svg.find(key);
  require(at != std::string::npos && at < svg.find('>'), "a figure without " + name);
  return std::stod(svg.substr(at + key.size()));
}

void replace_attribute(std::string& svg, const std::string& name, const std::string& value) {
  const auto at = svg.find(" " + name + "=\"") + name.size() + 3;
  svg.replace(at, svg.find('"', at) - at, value);
}

struct CurveColor {
  const char *color, *grey, *dash;
};

// The palette of studies/figures/panel.cpp.
constexpr std::array kCurveColors = {
    CurveColor{"#0072B2", "#000000", ""},        CurveColor{"#D55E00", "#000000", "6 3"},
    CurveColor{"#009E73", "#808080", ""},        CurveColor{"#CC79A7", "#808080", "6 3"},
    CurveColor{"#E69F00", "#000000", "1.5 2.5"}, CurveColor{"#56B4E9", "#000000", "7 2 1.5 2"},
    CurveColor{"#000000", "#808080", "1.5 2.5"}};

/// As bright as the colour: relative luminance, and sRGB's transfer function (IEC 61966-2-1).
std::string grey_of(const std::string& color) {
  const auto linear = [&](std::size_t at) {
    const double value = std::stoi(color.substr(at, 2), nullptr, 16) / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * linear(1) + 0.7152 * linear(3) + 0.0722 * linear(5);
  const double grey = y <= 0.0031308 ? 12.92 * y : 1.055 * std::pow(y, 1 / 2.4) - 0.055;
  const int level = static_cast<int>(std::lround(255 * grey));
  return fmt::format("#{0:02x}{0:02x}{0:02x}", level);
}

const CurveColor* curve_color(const std::string& color) {
  for (const CurveColor& each : kCurveColors)
    if (color == each.color) return &each;
  return nullptr;
}

bool is_curve(const std::string& tag) {
  return tag.starts_with("<polyline") || tag.starts_with("<line");
}

/// One tag; texts never get here, so nothing that a user named is changed.
std::string grey_tag(std::string tag) {
  for (const std::string key : {"stroke=\"#", "fill=\"#"}) {
    const auto found = tag.find(" " + key);
    if (found == std::string::npos) continue;
    const auto at = found + key.size();
    const std::string color = tag.substr(at, 7);
    const CurveColor* const curve = curve_color(color);
    tag.replace(at, 7, curve ? curve->grey : grey_of(color));
    const bool dashed = tag.find("stroke-dasharray") != std::string::npos;
    if (curve && is_curve(tag) && key[0] == 's' && *curve->dash != '\0' && !dashed)
      tag.insert(at + 8, fmt::format(" stroke-dasharray=\"{}\"", curve->dash));
  }
  return tag;
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

Format format_of(const std::string& path) {
  const std::string suffix = std::filesystem::path(path).extension().string();
  if (suffix == ".svg") return Format::kSvg;
  if (suffix == ".pdf") return Format::kPdf;
  if (suffix == ".png") return Format::kPng;
  throw Error(path + ": the name of a figure must end in .svg, .pdf or .png");
}

double length_in_mm(const std::string& text) {
  constexpr std::array<std::pair<const char*, double>, 5> kUnits{
      {{"mm", 1},
       {"cm", 10},
       {"in", kMmPerInch},
       {"pt", kMmPerInch / kPointsPerInch},
       {"px", kMmPerInch / kPxPerInch}}};
  std::string_view unit = text;
  const auto number = take_number(unit);
  for (const auto& [name, mm] : kUnits) {
    if (!number || unit != name) continue;
    const double length = *number * mm;
    require(length >= kNarrowestMm && length <= kWidestMm,
            fmt::format("width {}: must be {} mm to {} mm", text, kNarrowestMm, kWidestMm));
    return length;
  }
  throw Error(
      fmt::format("width '{}': must be a number with its unit, mm, cm, in, pt or px: 85mm", text));
}

std::string written(const std::string& svg, Format format, const Style& style) {
  const double width_px = attribute_of(svg, "width"), height_px = attribute_of(svg, "height");
  const double width_in = style.width_mm ? *style.width_mm / kMmPerInch : width_px / kPxPerInch;
  const double height_in = width_in * height_px / width_px;
  std::string styled = style.grey ? in_grey(svg) : svg;
  if (format == Format::kSvg) {
    if (style.width_mm) {
      replace_attribute(styled, "width", fmt::format("{:g}mm", width_in * kMmPerInch));
      replace_attribute(styled, "height", fmt::format("{:g}mm", height_in * kMmPerInch));
    }
    return styled;
  }
  const Size size{width_in, height_in};
  return format == Format::kPdf ? pdf(styled, size) : png(styled, size);
}

std::string in_grey(const std::string& svg) {
  std::string result;
  for (std::size_t at = 0; at < svg.size();) {
    const bool tag = svg[at] == '<';
    const auto next = svg.find(tag ? '>' : '<', at);
    const auto end = next == std::string::npos ? svg.size() : next + (tag ? 1 : 0);
    const std::string part = svg.substr(at, end - at);
    result += tag ? grey_tag(part) : part;
    at = end;
  }
  return result;
}

}  // namespace gurney::picture
