package org.dronewatch.mesh.io;

import java.io.BufferedReader;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import java.util.concurrent.CancellationException;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * Reads PLY files, text and binary: vertices with x, y and z, and faces. Other elements and properties, such as
 * colours, have no effect.
 */
public final class PlyReader implements MeshReader {
    private static final String MATERIAL = "default";

    /** A face with more corners is damage. */
    private static final int MOST_CORNERS = 100_000;

    private static final int LONGEST_WORD = 64;

    /** Creates a reader; it has no state. */
    public PlyReader() {
        // For the service loader.
    }

    @Override
    public Set<String> extensions() {
        return Set.of("ply");
    }

    @Override
    public String summary() {
        return "PLY, binary or text";
    }

    /** The numbers of a file, one after the other. */
    private interface Numbers {
        double next(PlyHeader.Type type) throws IOException;
    }

    @Override
    public LoadedModel read(ModelFile file, ModelSettings settings) {
        ModelCollector collector = new ModelCollector(file, settings);
        try (InputStream in = file.open()) {
            PlyHeader header = PlyHeader.read(file.name(), file.size(), in);
            Numbers numbers = header.order().isPresent()
                    ? binary(new DataInputStream(in), header.order().get())
                    : words(new BufferedReader(new InputStreamReader(in, StandardCharsets.US_ASCII)), file.name());
            boolean hasFaces = false;
            for (PlyHeader.Element element : header.elements()) {
                switch (element.name()) {
                    case "vertex" -> vertices(element, numbers, collector, file);
                    case "face" -> {
                        faces(element, numbers, collector, file);
                        hasFaces = element.count() > 0;
                    }
                    default -> skip(element, numbers);
                }
            }
            if (!hasFaces) {
                throw new InputException(file.name() + ": has no faces: a point cloud is not a mesh");
            }
        } catch (EOFException e) {
            throw new InputException(file.name() + ": ends too early: it is truncated or damaged", e);
        } catch (IOException e) {
            throw new InputException("model file " + file.name() + " cannot be read: " + e.getMessage(), e);
        }
        return collector.toModel();
    }

    private static void checkInterrupted() {
        if (Thread.currentThread().isInterrupted()) {
            throw new CancellationException("interrupted while a model was read");
        }
    }

    private static void vertices(PlyHeader.Element element, Numbers numbers, ModelCollector collector, ModelFile file)
            throws IOException {
        int[] axes = {element.indexOf("x"), element.indexOf("y"), element.indexOf("z")};
        for (int i = 0; i < 3; i++) {
            if (axes[i] < 0 || element.properties().get(axes[i]).count().isPresent()) {
                throw new InputException(file.name() + ": its vertices have no '" + "xyz".charAt(i) + "'");
            }
        }
        double[] values = new double[element.properties().size()];
        for (long i = 0; i < element.count(); i++) {
            checkInterrupted();
            for (int k = 0; k < values.length; k++) {
                values[k] = value(element.properties().get(k), numbers, file);
            }
            collector.addVertex(values[axes[0]], values[axes[1]], values[axes[2]]);
        }
    }

    /** A single value; that of a list, which is skipped, is 0. */
    private static double value(PlyHeader.Property property, Numbers numbers, ModelFile file) throws IOException {
        if (property.count().isEmpty()) {
            return numbers.next(property.type());
        }
        int count = length(property, numbers, file);
        for (int i = 0; i < count; i++) {
            numbers.next(property.type());
        }
        return 0.0;
    }

    private static int length(PlyHeader.Property list, Numbers numbers, ModelFile file) throws IOException {
        double count = numbers.next(list.count().orElseThrow());
        if (!(count >= 0.0 && count <= MOST_CORNERS && count == Math.rint(count))) {
            throw new InputException(file.name() + ": a list '" + PlainText.value(list.name()) + "' has "
                    + (float) count + " values but must have 0 to " + MOST_CORNERS);
        }
        return (int) count;
    }

    private static void faces(PlyHeader.Element element, Numbers numbers, ModelCollector collector, ModelFile file)
            throws IOException {
        int corners = Math.max(element.indexOf("vertex_indices"), element.indexOf("vertex_index"));
        if (corners < 0 || element.properties().get(corners).count().isEmpty()) {
            throw new InputException(file.name() + ": its faces have no list 'vertex_indices'");
        }
        for (long i = 0; i < element.count(); i++) {
            checkInterrupted();
            for (int k = 0; k < element.properties().size(); k++) {
                PlyHeader.Property property = element.properties().get(k);
                if (k == corners) {
                    face(property, numbers, collector, file);
                } else {
                    value(property, numbers, file);
                }
            }
        }
    }

    private static void face(PlyHeader.Property list, Numbers numbers, ModelCollector collector, ModelFile file)
            throws IOException {
        int[] corners = new int[length(list, numbers, file)];
        for (int i = 0; i < corners.length; i++) {
            double corner = numbers.next(list.type());
            corners[i] = corner >= 0.0 && corner <= Integer.MAX_VALUE ? (int) corner : -1;
        }
        collector.addFace(MATERIAL, corners);
    }

    private static void skip(PlyHeader.Element element, Numbers numbers) throws IOException {
        for (long i = 0; i < element.count(); i++) {
            checkInterrupted();
            for (PlyHeader.Property property : element.properties()) {
                double count = property.count().isPresent()
                        ? numbers.next(property.count().get())
                        : 1.0;
                for (double k = 0; k < count; k++) {
                    numbers.next(property.type());
                }
            }
        }
    }

    private static Numbers binary(DataInputStream in, ByteOrder order) {
        byte[] bytes = new byte[Double.BYTES];
        ByteBuffer buffer = ByteBuffer.wrap(bytes).order(order);
        return type -> {
            in.readFully(bytes, 0, type.bytes);
            return switch (type) {
                case INT8 -> bytes[0];
                case UINT8 -> Byte.toUnsignedInt(bytes[0]);
                case INT16 -> buffer.getShort(0);
                case UINT16 -> Short.toUnsignedInt(buffer.getShort(0));
                case INT32 -> buffer.getInt(0);
                case UINT32 -> Integer.toUnsignedLong(buffer.getInt(0));
                case FLOAT32 -> buffer.getFloat(0);
                case FLOAT64 -> buffer.getDouble(0);
            };
        };
    }

    private static Numbers words(BufferedReader in, String file) {
        StringBuilder word = new StringBuilder();
        return type -> {
            word.setLength(0);
            int one = in.read();
            while (one >= 0 && Character.isWhitespace(one)) {
                one = in.read();
            }
            while (one >= 0 && !Character.isWhitespace(one) && word.length() < LONGEST_WORD) {
                word.append((char) one);
                one = in.read();
            }
            if (word.isEmpty()) {
                throw new EOFException();
            }
            if (one >= 0 && !Character.isWhitespace(one)) {
                throw new InputException(file + ": a number of more than " + LONGEST_WORD + " characters: '"
                        + PlainText.value(word.toString()) + "'");
            }
            try {
                return Double.parseDouble(word.toString());
            } catch (NumberFormatException e) {
                throw new InputException(file + ": not a number: '" + PlainText.value(word.toString()) + "'", e);
            }
        };
    }
}
