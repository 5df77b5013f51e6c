package org.dronewatch.terrain.io;

import java.io.IOException;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.setting.InputException;

/**
 * A GeoTIFF or BigTIFF file with one band of whole or real numbers in either byte order, in strips or tiles that are
 * uncompressed or compressed by LZW, deflate or PackBits, also with predictors 2 and 3. Tiles that are left out of a
 * sparse file are holes.
 */
final class GeoTiffFile implements ElevationFile {
    private static final int COLUMNS = 256;
    private static final int ROWS = 257;
    private static final int BITS = 258;
    private static final int COMPRESSION = 259;
    private static final int STRIP_OFFSETS = 273;
    private static final int BANDS = 277;
    private static final int STRIP_ROWS = 278;
    private static final int STRIP_BYTES = 279;
    private static final int PREDICTOR = 317;
    private static final int TILE_COLUMNS = 322;
    private static final int TILE_ROWS = 323;
    private static final int TILE_OFFSETS = 324;
    private static final int TILE_BYTES = 325;
    private static final int FORMAT = 339;
    private static final int METADATA = 42112;
    private static final int NODATA = 42113;

    private static final int MOST_SIDE = 1 << 24;
    private static final int MOST_BLOCK_POSTS = 1 << 25;
    private static final int MOST_BLOCK_BYTES = 1 << 28;

    /** How a file that cannot be read becomes one that can. */
    private static final String CONVERT = "gdal_translate -co COMPRESS=DEFLATE -co TILED=YES %s dem.tif";

    private static final Map<Integer, String> COMPRESSIONS =
            Map.of(1, "none", 5, "LZW", 8, "deflate", 32946, "deflate", 32773, "PackBits");

    private static final Map<Integer, String> REFUSED = Map.of(
            6, "JPEG", 7, "JPEG", 34712, "JPEG 2000", 34887, "LERC", 34925, "LZMA", 50000, "ZSTD", 50001, "WebP");

    private final ElevationBytes bytes;
    private final TiffDirectory tags;
    private final int columns;
    private final int rows;
    private final int blockColumns;
    private final int blockRows;
    private final long[] offsets;
    private final long[] lengths;
    private final boolean isTiled;
    private final TiffBlock block;
    private final GeoKeys keys;
    private final Lattice lattice;
    private final OptionalDouble nodata;
    private final double scale;
    private final double offset;

    /** A file. */
    GeoTiffFile(ElevationBytes bytes) throws IOException {
        this.bytes = bytes;
        this.tags = new TiffDirectory(bytes);
        this.columns = number(COLUMNS, "columns", 2, MOST_SIDE);
        this.rows = number(ROWS, "rows", 2, MOST_SIDE);
        long bands = tags.single(BANDS, 1);
        if (bands != 1) {
            throw new InputException(bytes.name() + ": has " + bands
                    + " bands, but elevations have one; gdal_translate -b 1 takes the first");
        }
        this.block = block();
        this.isTiled = tags.has(TILE_OFFSETS);
        this.blockColumns = isTiled ? number(TILE_COLUMNS, "columns of a tile", 1, 1 << 20) : columns;
        this.blockRows = isTiled
                ? number(TILE_ROWS, "rows of a tile", 1, 1 << 20)
                : (int) Math.max(1, Math.min(rows, tags.single(STRIP_ROWS, rows)));
        this.offsets = tags.longs(isTiled ? TILE_OFFSETS : STRIP_OFFSETS);
        this.lengths = tags.longs(isTiled ? TILE_BYTES : STRIP_BYTES);
        checkBlocks();
        this.keys = new GeoKeys(bytes.name(), tags);
        this.lattice = keys.lattice();
        this.nodata = nodata();
        GdalMetadata metadata = new GdalMetadata(bytes.name(), tags.text(METADATA));
        this.scale = metadata.factor("scale", 1.0);
        this.offset = metadata.factor("offset", 0.0);
    }

    private int number(int tag, String what, int from, int to) throws IOException {
        long value = tags.single(tag, -1);
        if (value < from || value > to) {
            throw new InputException(bytes.name() + ": "
                    + (value < 0 ? "does not state its number of " + what : "has " + value + " " + what)
                    + "; there must be " + from + " to " + to);
        }
        return (int) value;
    }

    private TiffBlock block() throws IOException {
        int compression = (int) tags.single(COMPRESSION, 1);
        if (!COMPRESSIONS.containsKey(compression)) {
            throw unreadable(
                    "its compression, " + REFUSED.getOrDefault(compression, "unknown") + " (" + compression + "),");
        }
        int bits = (int) tags.single(BITS, 1);
        int format = (int) tags.single(FORMAT, 1);
        boolean isWhole = (format == 1 || format == TiffBlock.SIGNED) && (bits == 8 || bits == 16 || bits == 32);
        boolean isReal = format == TiffBlock.REAL && (bits == 32 || bits == 64);
        if (!isWhole && !isReal) {
            throw unreadable("a sample of " + bits + " bits in sample format " + format);
        }
        int predictor = (int) tags.single(PREDICTOR, 1);
        if (predictor < 1 || predictor > 3) {
            throw unreadable("predictor " + predictor);
        }
        return new TiffBlock(tags.order(), bits, format, compression, predictor);
    }

    private InputException unreadable(String what) {
        return new InputException(String.format(
                Locale.ROOT,
                "%s: %s is not supported: convert the file, as in " + CONVERT,
                bytes.name(),
                what,
                bytes.shortName()));
    }

    private void checkBlocks() {
        if ((long) blockColumns * blockRows > MOST_BLOCK_POSTS) {
            throw new InputException(String.format(
                    Locale.ROOT,
                    "%s: has blocks of %d x %d posts but must have at most %,d in a block: convert the file, as in "
                            + CONVERT,
                    bytes.name(),
                    blockColumns,
                    blockRows,
                    MOST_BLOCK_POSTS,
                    bytes.shortName()));
        }
        long blocks = (long) blocksAcross() * ((rows + blockRows - 1L) / blockRows);
        if (offsets.length != blocks || lengths.length != blocks) {
            throw new InputException(String.format(
                    Locale.ROOT,
                    "%s: %d x %d posts make %,d blocks, but it has offsets of %,d and lengths of %,d: it is damaged",
                    bytes.name(),
                    columns,
                    rows,
                    blocks,
                    offsets.length,
                    lengths.length));
        }
    }

    private int blocksAcross() {
        return (int) ((columns + blockColumns - 1L) / blockColumns);
    }

    private OptionalDouble nodata() throws IOException {
        String text = tags.text(NODATA);
        if (text.isEmpty() || text.equalsIgnoreCase("nan") || text.equalsIgnoreCase("none")) {
            return OptionalDouble.empty();
        }
        try {
            return OptionalDouble.of(Double.parseDouble(text));
        } catch (NumberFormatException e) {
            throw new InputException(bytes.name() + ": nodata (tag 42113) '" + text + "' must be a number", e);
        }
    }

    @Override
    public String name() {
        return bytes.name();
    }

    @Override
    public int columns() {
        return columns;
    }

    @Override
    public int rows() {
        return rows;
    }

    @Override
    public Lattice lattice() {
        return lattice;
    }

    @Override
    public Optional<CoordinateReferenceSystem> crs() {
        return keys.crs();
    }

    @Override
    public Optional<String> statedCrs() {
        return keys.statedCrs();
    }

    @Override
    public boolean statesUnit() {
        return keys.statesUnit();
    }

    @Override
    public boolean isSurfaceModel() {
        return SurfaceModels.isOne(bytes.shortName());
    }

    @Override
    public boolean statesNodata() {
        return tags.has(NODATA);
    }

    @Override
    public float[] heights(Window window) throws IOException {
        float[] heights = new float[(int) window.posts()];
        Arrays.fill(heights, Float.NaN);
        double unit = keys.unit();
        for (int down = window.row() / blockRows; down * (long) blockRows < window.row() + window.rows(); down++) {
            for (int across = window.column() / blockColumns;
                    across * (long) blockColumns < window.column() + window.columns();
                    across++) {
                readBlock(across, down, window, unit, heights);
            }
        }
        return heights;
    }

    private void readBlock(int across, int down, Window window, double unit, float[] heights) throws IOException {
        int number = down * blocksAcross() + across;
        if (lengths[number] == 0 || offsets[number] == 0) {
            return;
        }
        Window all = new Window(
                across * blockColumns,
                down * blockRows,
                blockColumns,
                isTiled ? blockRows : Math.min(blockRows, rows - down * blockRows));
        double[] samples = decoded(number, all);
        Window part = all.and(window);
        for (int row = part.row(); row < part.row() + part.rows(); row++) {
            int from = (row - all.row()) * all.columns() - all.column();
            int to = (row - window.row()) * window.columns() - window.column();
            for (int column = part.column(); column < part.column() + part.columns(); column++) {
                heights[to + column] = height(samples[from + column], unit);
            }
        }
    }

    private double[] decoded(int number, Window all) throws IOException {
        String what = (isTiled ? "tile " : "strip ") + number;
        if (lengths[number] < 0 || lengths[number] > MOST_BLOCK_BYTES) {
            throw new InputException(bytes.name() + ": " + what + " has " + lengths[number]
                    + " bytes but must have at most " + MOST_BLOCK_BYTES);
        }
        if (offsets[number] < 0 || offsets[number] > bytes.size() - lengths[number]) {
            throw new InputException(String.format(
                    Locale.ROOT,
                    "%s: %s of %,d bytes at byte %,d ends beyond the file's %,d bytes: it is truncated or damaged",
                    bytes.name(),
                    what,
                    lengths[number],
                    offsets[number],
                    bytes.size()));
        }
        byte[] compressed = bytes.read(offsets[number], (int) lengths[number]);
        try {
            return block.decode(compressed, all.columns(), all.rows());
        } catch (IOException e) {
            throw new InputException(
                    bytes.name() + ": " + what + " is damaged (" + COMPRESSIONS.get(block.compression()) + "): "
                            + e.getMessage(),
                    e);
        }
    }

    private float height(double sample, double unit) {
        boolean isHole = nodata.isPresent()
                && (sample == nodata.getAsDouble() || (float) sample == (float) nodata.getAsDouble());
        return isHole ? Float.NaN : (float) ((sample * scale + offset) * unit);
    }
}
