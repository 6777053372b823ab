#include "core/io/png_decoder.h"

#include <bit>
#include <cstring>
#include <new>

#include <png.h>

namespace dirt {

/// libpng leaves a failed call by longjmp to where setjmp was called: so what stands between the
/// two has no destructors, and the message goes through here.
struct PngDecoder::State {
    explicit State(const std::string& bytes) : rest(bytes.data()), left(bytes.size()) {}
    ~State() { png_destroy_read_struct(&png, &info, nullptr); }

    static void fail(png_structp png, png_const_charp message) {
        auto& state = *(State*) png_get_error_ptr(png);
        std::strncpy(state.message, message, sizeof state.message - 1);
        png_longjmp(png, 1);
    }

    static void give(png_structp png, png_bytep to, size_t count) {
        auto& state = *(State*) png_get_io_ptr(png);
        if (count > state.left) png_error(png, "the file ends early");
        std::memcpy(to, state.rest, count);
        state.rest += count;
        state.left -= count;
    }

    /// Throws what \p step fails with. It must hold nothing that has a destructor.
    template <typename Step>
    void guard(const Step& step) {
        if (setjmp(png_jmpbuf(png))) throw PngError(message);
        step();
    }

    void readHeader() {
        png_set_read_fn(png, this, give);
        // Colours stay as they are stored: besides the texels only a transparent colour matters
        // (which the first line leaves), and texts. What is not read cannot do harm.
        png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
        png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_AS_DEFAULT, (png_const_bytep) "tEXt", 1);
        png_read_info(png, info);
        const int type = png_get_color_type(png, info);
        if (type == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png);
        if (type == PNG_COLOR_TYPE_GRAY && png_get_bit_depth(png, info) < 8)
            png_set_expand_gray_1_2_4_to_8(png);
        if (png_get_valid(png, info, PNG_INFO_tRNS)) png_set_tRNS_to_alpha(png);
        if (std::endian::native == std::endian::little) png_set_swap(png);
        png_set_interlace_handling(png);
        png_read_update_info(png, info);
        header = {(int) png_get_image_width(png, info), (int) png_get_image_height(png, info),
                  png_get_channels(png, info), png_get_bit_depth(png, info)};
    }

    const char* rest;
    size_t left;
    png_structp png = nullptr;
    png_infop info = nullptr;
    PngHeader header{};
    char message[100] = {};
};

PngDecoder::PngDecoder(const std::string& bytes) : state_(std::make_unique<State>(bytes)) {
    State& s = *state_;
    s.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &s, State::fail,
                                   [](png_structp, png_const_charp) {}); // warnings
    s.info = s.png ? png_create_info_struct(s.png) : nullptr;
    if (!s.info) throw std::bad_alloc();
    s.guard([&s] { s.readHeader(); });
}

PngDecoder::~PngDecoder() = default;

const PngHeader& PngDecoder::header() const {
    return state_->header;
}

std::vector<std::pair<std::string, std::string>> PngDecoder::texts() const {
    png_textp texts = nullptr;
    const int count = png_get_text(state_->png, state_->info, &texts, nullptr);
    std::vector<std::pair<std::string, std::string>> list;
    for (int i = 0; i < count; ++i) list.emplace_back(texts[i].key, texts[i].text);
    return list;
}

std::vector<uint8_t> PngDecoder::decode() {
    State& s = *state_;
    const size_t rowBytes = png_get_rowbytes(s.png, s.info);
    std::vector<uint8_t> samples(rowBytes * (size_t) s.header.height);
    std::vector<uint8_t*> rows((size_t) s.header.height);
    for (size_t y = 0; y < rows.size(); ++y) rows[y] = samples.data() + y * rowBytes;
    s.guard([&s, &rows] {
        png_read_image(s.png, rows.data());
        png_read_end(s.png, nullptr);
    });
    return samples;
}

} // namespace dirt
