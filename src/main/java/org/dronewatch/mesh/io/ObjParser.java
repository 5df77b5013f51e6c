package org.dronewatch.mesh.io;

import java.io.IOException;
import java.util.Locale;
import org.dronewatch.geometry.Ints;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * Reads the statements of an OBJ file into a collector. Keywords may be in capitals. An invalid statement, or one whose
 * keyword the format does not have, is an {@link InputException} that names file and line.
 */
final class ObjParser {
    private static final int MAX_DIGITS = 9;
    private static final int LONGEST_EXCERPT = 40;

    /** From here on single precision loses a tenth of a millimetre, m. */
    private static final float FAR = 1000f;

    private final String file;
    private final ObjLines lines;
    private final ObjMeshCollector collector;
    private final Ints corners = new Ints();
    private final double[] coordinates = new double[3];

    // What is left of the statement.
    private char[] text = {};
    private int next;
    private int end;

    ObjParser(String file, ObjLines lines, ObjMeshCollector collector) {
        this.file = file;
        this.lines = lines;
        this.collector = collector;
    }

    /** Reads to the end of the file. */
    void read() throws IOException {
        while (lines.advance()) {
            text = lines.characters();
            next = lines.start();
            end = lines.end();
            if (next < end && text[next] != '#') {
                statement();
            }
        }
    }

    private void statement() {
        int start = nextToken();
        // Nearly all are one of these two.
        int letter = next - start == 1 ? text[start] : 0;
        if (letter == 'v' || letter == 'V') {
            vertex();
        } else if (letter == 'f' || letter == 'F') {
            face();
        } else {
            statement(textFrom(start));
        }
    }

    private void statement(String word) {
        String known = word.toLowerCase(Locale.ROOT);
        switch (known) {
            // A face outline is what old files have for a face.
            case "fo" -> face();
            case "usemtl" -> collector.useMaterial(rest());
            case "mtllib" -> collector.addLibrary(rest());
            default -> {
                if (!ObjWords.isSkipped(known)) {
                    throw wrong("unknown keyword " + quoted(word) + ": no statement of the OBJ format begins with it");
                }
                collector.skip(known);
            }
        }
    }

    /** Three coordinates; what may follow them, a weight or a colour, must be numbers and has no effect. */
    private void vertex() {
        int count = 0;
        for (int start = nextToken(); start < next; start = nextToken()) {
            double value = number(start);
            if (count < coordinates.length) {
                coordinates[count] = value;
            }
            count++;
        }
        if (count < coordinates.length) {
            throw wrong("vertex has " + Counted.of(count, "coordinate") + " but needs 3");
        }
        collector.addVertex(coordinates[0], coordinates[1], coordinates[2]);
    }

    /**
     * A number in single precision, which suffices near the origin; coordinates of national grids need double
     * precision.
     */
    private double number(int start) {
        double plain = PlainDecimal.read(text, start, next);
        // Not a number where it is not written plainly.
        if (Math.abs(plain) < FAR - 1f && PlainDecimal.isSafeAsFloat(plain)) {
            return (float) plain;
        }
        String token = textFrom(start);
        try {
            float value = Float.parseFloat(token);
            return Math.abs(value) < FAR ? value : Double.parseDouble(token);
        } catch (NumberFormatException e) {
            throw new InputException(lines.at(file) + "not a number: " + quoted(token), e);
        }
    }

    private void face() {
        corners.clear();
        for (int start = nextToken(); start < next; start = nextToken()) {
            corners.add(corner(start));
        }
        collector.addFace(corners);
    }

    /** The vertex index of a corner such as {@code 3}, {@code -1}, {@code 3/1}, {@code 3//2} or {@code 3/1/2}. */
    private int corner(int start) {
        int first = slash(start);
        if (first < next) {
            // Texture coordinates and normals have no effect, but their indices must be valid.
            int second = slash(first + 1);
            if (second > first + 1) {
                index(first + 1, second, start);
            }
            if (second + 1 < next) {
                index(second + 1, next, start);
            }
        }
        return index(start, first, start);
    }

    /** Where the next slash of the token is, or where the token ends. */
    private int slash(int from) {
        int at = from;
        while (at < next && text[at] != '/') {
            at++;
        }
        return at;
    }

    private int index(int from, int to, int corner) {
        boolean isNegative = from < to && text[from] == '-';
        int digits = isNegative ? from + 1 : from;
        int index = 0;
        for (int i = digits; i < to; i++) {
            if (text[i] < '0' || text[i] > '9') {
                throw wrong("not a corner of a face: " + quoted(textFrom(corner)));
            }
            // What overflows is refused below.
            index = 10 * index + (text[i] - '0');
        }
        if (to == digits) {
            throw wrong("not a corner of a face: " + quoted(textFrom(corner)));
        }
        if (to - digits > MAX_DIGITS) {
            throw wrong("index of more than " + MAX_DIGITS + " digits: " + quoted(textFrom(corner)));
        }
        return isNegative ? -index : index;
    }

    /**
     * Goes to the end of the next token of the statement: it is what lies between its start and {@code next}, and is
     * empty at the end.
     *
     * @return its start
     */
    private int nextToken() {
        int at = next;
        while (at < end && ObjLines.isWhite(text[at])) {
            at++;
        }
        int start = at;
        while (at < end && !ObjLines.isWhite(text[at])) {
            at++;
        }
        next = at;
        return start;
    }

    /** The text from a place up to {@code next}. */
    private String textFrom(int start) {
        return new String(text, start, next - start);
    }

    private String rest() {
        return new String(text, next, end - next).strip();
    }

    private InputException wrong(String what) {
        return new InputException(lines.at(file) + what);
    }

    private static String quoted(String text) {
        return "'" + PlainText.beginning(text, LONGEST_EXCERPT) + "'";
    }
}
