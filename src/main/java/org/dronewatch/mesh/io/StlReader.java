package org.dronewatch.mesh.io;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.CancellationException;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * Reads STL files, binary and text. The format states no unit: unless the scene states one, coordinates are taken as
 * metres, with a warning. The format has no materials, and the normals in a file have no effect.
 */
public final class StlReader implements MeshReader {
    private static final int HEADER = 80;
    private static final int FACET = 50;
    private static final int COORDINATES = 9;
    private static final String MATERIAL = "default";
    private static final Set<String> KEYWORDS = Set.of("solid", "facet", "outer", "endfacet", "color");

    /** Creates a reader; it has no state. */
    public StlReader() {
        // For the service loader.
    }

    @Override
    public Set<String> extensions() {
        return Set.of("stl");
    }

    @Override
    public String summary() {
        return "STL, binary or text; without units or materials";
    }

    @Override
    public LoadedModel read(ModelFile file, ModelSettings settings) {
        ModelCollector collector = new ModelCollector(file, settings);
        try {
            if (isBinary(file)) {
                readBinary(file, collector);
            } else {
                readText(file, collector);
            }
        } catch (EOFException e) {
            throw new InputException(file.name() + ": ends too early: it is truncated or damaged", e);
        } catch (IOException e) {
            throw new InputException("model file " + file.name() + " cannot be read: " + e.getMessage(), e);
        }
        if (settings.scale() == 1.0) {
            collector.warn(file.name()
                    + ": STL states no unit, so its coordinates are taken to be in metres; set scale: 0.001 if they are in"
                    + " millimetres");
        }
        return collector.toModel();
    }

    /** Text begins with 'solid', and so do some binary files: the length decides. */
    private static boolean isBinary(ModelFile file) throws IOException {
        try (DataInputStream in = new DataInputStream(file.open())) {
            byte[] start = in.readNBytes(HEADER);
            boolean saysSolid = new String(start, StandardCharsets.ISO_8859_1)
                    .strip()
                    .toLowerCase(Locale.ROOT)
                    .startsWith("solid");
            if (!saysSolid) {
                return true;
            }
            byte[] count = in.readNBytes(Integer.BYTES);
            if (new String(start, StandardCharsets.ISO_8859_1).indexOf('\0') >= 0) {
                return true;
            }
            return count.length == Integer.BYTES
                    && file.size()
                            == HEADER
                                    + Integer.BYTES
                                    + FACET
                                            * Integer.toUnsignedLong(
                                                    little(count).getInt());
        }
    }

    private static ByteBuffer little(byte[] bytes) {
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    private static void readBinary(ModelFile file, ModelCollector collector) throws IOException {
        try (InputStream in = file.open()) {
            byte[] header = exactly(in, HEADER + Integer.BYTES);
            long facets = Integer.toUnsignedLong(little(header).getInt(HEADER));
            long needed = HEADER + Integer.BYTES + FACET * facets;
            if (file.size() < needed) {
                throw new InputException(String.format(
                        Locale.ROOT,
                        "%s: states %s, which would take %,d bytes, but has %,d: not STL, or truncated",
                        file.name(),
                        Counted.of(facets, "facet"),
                        needed,
                        file.size()));
            }
            for (long facet = 0; facet < facets; facet++) {
                if (Thread.currentThread().isInterrupted()) {
                    throw new CancellationException("interrupted while a model was read");
                }
                ByteBuffer one = little(exactly(in, FACET));
                int first = 0;
                for (int corner = 0; corner < 3; corner++) {
                    int at = 3 * Float.BYTES * (corner + 1);
                    first = collector.addVertex(
                            one.getFloat(at), one.getFloat(at + Float.BYTES), one.getFloat(at + 2 * Float.BYTES));
                }
                collector.addFace(MATERIAL, first - 2, first - 1, first);
            }
        }
    }

    private static byte[] exactly(InputStream in, int length) throws IOException {
        byte[] bytes = in.readNBytes(length);
        if (bytes.length < length) {
            throw new EOFException();
        }
        return bytes;
    }

    private static void readText(ModelFile file, ModelCollector collector) throws IOException {
        double[] corners = new double[COORDINATES];
        int count = 0;
        boolean hasEnded = false;
        try (ObjLines lines = new ObjLines(file.text())) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                String[] words = line.strip().split("\\s+");
                String word = words[0].toLowerCase(Locale.ROOT);
                if (word.equals("vertex")) {
                    if (words.length != 4 || count == COORDINATES) {
                        throw new InputException(lines.at(file.name())
                                + (words.length != 4
                                        ? "a vertex needs three coordinates"
                                        : "a facet has more than three corners"));
                    }
                    for (int axis = 0; axis < 3; axis++) {
                        corners[count++] = number(words[axis + 1], lines, file);
                    }
                } else if (word.equals("endloop")) {
                    if (count != COORDINATES) {
                        throw new InputException(lines.at(file.name()) + "a facet has "
                                + Counted.of(count / 3, "corner") + " but needs 3");
                    }
                    int last = 0;
                    for (int i = 0; i < COORDINATES; i += 3) {
                        last = collector.addVertex(corners[i], corners[i + 1], corners[i + 2]);
                    }
                    collector.addFace(MATERIAL, last - 2, last - 1, last);
                    count = 0;
                } else if (word.equals("endsolid")) {
                    hasEnded = true;
                } else if (!word.isEmpty() && !KEYWORDS.contains(word)) {
                    throw new InputException(lines.at(file.name()) + "unknown keyword '" + PlainText.value(words[0])
                            + "': no statement of STL begins with it");
                }
            }
        }
        if (count != 0 || !hasEnded) {
            throw new InputException(file.name() + ": ends without 'endsolid': it is truncated or damaged");
        }
    }

    private static double number(String text, ObjLines lines, ModelFile file) {
        try {
            double number = Double.parseDouble(text);
            if (!Double.isFinite(number)) {
                throw new InputException(
                        lines.at(file.name()) + "a coordinate must be finite, not " + PlainText.value(text));
            }
            return number;
        } catch (NumberFormatException e) {
            throw new InputException(lines.at(file.name()) + "not a number: '" + PlainText.value(text) + "'", e);
        }
    }
}
