package org.dronewatch.terrain.io;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * An ESRI ASCII grid: lines of a key and a value (ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter,
 * cellsize or dx and dy, optionally NODATA_value), then the heights from the northernmost row to the southernmost.
 * Without a NODATA_value, -9999 means that there is no height, as in Esri's own programs.
 */
final class AsciiGridFile implements ElevationFile {
    private static final double USUAL_NODATA = -9999.0;
    private static final int LONGEST_WORD = 64;
    /** The first words of the lines of a header, in lower case. */
    static final Set<String> KEYS = Set.of(
            "ncols",
            "nrows",
            "xllcorner",
            "xllcenter",
            "yllcorner",
            "yllcenter",
            "cellsize",
            "dx",
            "dy",
            "nodata_value");

    private final ElevationBytes bytes;
    private final Map<String, Double> header = new HashMap<>();
    private final int columns;
    private final int rows;
    private final Lattice lattice;
    private final double nodata;

    /** A grid. */
    AsciiGridFile(ElevationBytes bytes) throws IOException {
        this.bytes = bytes;
        try (Words words = new Words(bytes)) {
            readHeader(words);
        }
        columns = count("ncols");
        rows = count("nrows");
        if (2L * columns * rows > bytes.size() + 1) {
            throw new InputException(String.format(
                    Locale.ROOT,
                    "%s: states %d x %d posts, but has only %,d bytes: it is truncated or damaged",
                    bytes.name(),
                    columns,
                    rows,
                    bytes.size()));
        }
        double dx = size(header.containsKey("dx") ? "dx" : "cellsize");
        double dy = size(header.containsKey("dy") ? "dy" : "cellsize");
        double west = first("xllcorner", "xllcenter", 0.5 * dx);
        double south = first("yllcorner", "yllcenter", 0.5 * dy);
        lattice = new Lattice(west, south + (rows - 1) * dy, dx, 0.0, 0.0, -dy);
        nodata = header.getOrDefault("nodata_value", USUAL_NODATA);
    }

    private void readHeader(Words words) throws IOException {
        String key = words.peek().toLowerCase(Locale.ROOT);
        while (KEYS.contains(key)) {
            words.next();
            int line = words.line();
            String value = words.next();
            if (header.put(key, number(value, line)) != null) {
                throw new InputException(bytes.name() + ":" + line + ": '" + key + "' is given twice");
            }
            key = words.peek().toLowerCase(Locale.ROOT);
        }
    }

    private double number(String word, int line) {
        if (word.equalsIgnoreCase("nan")) {
            // As GDAL writes it.
            return Double.NaN;
        }
        try {
            return Double.parseDouble(word);
        } catch (NumberFormatException e) {
            throw new InputException(
                    bytes.name() + ":" + line + ": '" + PlainText.value(word) + "' must be a number", e);
        }
    }

    private double value(String key) {
        Double value = header.get(key);
        if (value == null) {
            throw new InputException(bytes.name() + ": its header needs '" + key + "'");
        }
        return value;
    }

    private int count(String key) {
        double value = value(key);
        if (!(value >= 2.0 && value <= Integer.MAX_VALUE) || value != Math.rint(value)) {
            throw new InputException(bytes.name() + ": " + key + " " + value + " must be a whole number of 2 or more");
        }
        return (int) value;
    }

    private double size(String key) {
        double value = value(key);
        if (!(value > 0.0 && Double.isFinite(value))) {
            throw new InputException(bytes.name() + ": " + key + " " + value + " must be above 0");
        }
        return value;
    }

    /** The first column's or last row's centre. */
    private double first(String corner, String centre, double half) {
        double value = header.containsKey(centre) ? value(centre) : value(corner) + half;
        if (!Double.isFinite(value)) {
            throw new InputException(bytes.name() + ": " + corner + " " + value + " must be finite");
        }
        return value;
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
        return Optional.empty();
    }

    @Override
    public boolean statesUnit() {
        return false;
    }

    @Override
    public float[] heights(Window window) throws IOException {
        float[] heights = new float[(int) window.posts()];
        Arrays.fill(heights, Float.NaN);
        try (Words words = new Words(bytes)) {
            for (int i = 0; i < 2 * header.size(); i++) {
                words.next();
            }
            for (int row = 0; row < window.row() + window.rows(); row++) {
                for (int column = 0; column < columns; column++) {
                    String word = word(words, row, column);
                    int inside = column - window.column();
                    if (row >= window.row() && inside >= 0 && inside < window.columns()) {
                        double height = number(word, words.line());
                        boolean isHole = height == nodata || (float) height == (float) nodata;
                        heights[(row - window.row()) * window.columns() + inside] = isHole ? Float.NaN : (float) height;
                    }
                }
            }
            if (window.row() + window.rows() == rows && !words.isAtEnd()) {
                throw new InputException(bytes.name() + ":" + words.line() + ": has more heights than the "
                        + (long) rows * columns + " that its header states");
            }
        }
        return heights;
    }

    private String word(Words words, int row, int column) throws IOException {
        try {
            return words.next();
        } catch (EOFException e) {
            throw new InputException(
                    String.format(
                            Locale.ROOT,
                            "%s: ends after %,d of %,d heights",
                            bytes.name(),
                            (long) row * columns + column,
                            (long) rows * columns),
                    e);
        }
    }

    @Override
    public boolean isSurfaceModel() {
        return SurfaceModels.isOne(bytes.shortName());
    }

    @Override
    public boolean statesNodata() {
        return header.containsKey("nodata_value");
    }

    /** The text between spaces and ends of lines. */
    private static final class Words implements AutoCloseable {
        private final InputStream in;
        private final String name;
        private final StringBuilder word = new StringBuilder();
        private boolean isAhead;
        private int line = 1;
        private int lineOfWord = 1;

        Words(ElevationBytes bytes) throws IOException {
            this.in = bytes.open();
            this.name = bytes.name();
        }

        /** The line of the last word, from 1 on. */
        int line() {
            return lineOfWord;
        }

        String peek() throws IOException {
            if (!isAhead) {
                read();
                isAhead = true;
            }
            return word.toString();
        }

        String next() throws IOException {
            String found = peek();
            isAhead = false;
            return found;
        }

        /** Whether no word is left; the line becomes that of the next one. */
        boolean isAtEnd() throws IOException {
            try {
                peek();
                return false;
            } catch (EOFException e) {
                return true;
            }
        }

        private void read() throws IOException {
            word.setLength(0);
            int one = in.read();
            while (one == ' ' || one == '\t' || one == '\r' || one == '\n') {
                line += one == '\n' ? 1 : 0;
                one = in.read();
            }
            if (one < 0) {
                throw new EOFException(name + ": ends before its first height");
            }
            lineOfWord = line;
            while (one > ' ') {
                if (word.length() == LONGEST_WORD) {
                    throw new InputException(name + ":" + line + ": a number of more than " + LONGEST_WORD
                            + " characters: '" + PlainText.value(word.toString()) + "'");
                }
                word.append((char) one);
                one = in.read();
            }
            line += one == '\n' ? 1 : 0;
        }

        @Override
        public void close() throws IOException {
            in.close();
        }
    }
}
