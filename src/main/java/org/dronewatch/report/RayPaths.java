package org.dronewatch.report;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.setting.Counted;

/**
 * Recorded rays as lines of an OBJ file, in the frame of the packaged models (metres, y up, north is -z), so that they
 * can be viewed together with the model. A group holds the segments of one sensor, drone and reflection order; segments
 * that end at the sensor are in separate groups.
 */
public final class RayPaths {
    /** A ray segment in the world's frame, and its level. */
    private record Piece(double[] ends, double level) {}

    /** A line feed on every system, so that the file is the same. */
    private static final String LINE = "\n";

    private final Map<String, List<Piece>> groups = new LinkedHashMap<>();
    private int pieces;

    /** The recorder for rays that are traced between the sensor and the drone with the given names. */
    public RayRecorder recorder(String sensor, String drone) {
        return (fromX, fromY, fromZ, toX, toY, toZ, level, order, received) -> {
            String group = sensor + "_" + drone + "_order_" + order + (received ? "_received" : "");
            double[] ends = {fromX, fromY, fromZ, toX, toY, toZ};
            groups.computeIfAbsent(group, name -> new ArrayList<>()).add(new Piece(ends, level));
            pieces++;
        };
    }

    /** Number of recorded segments. */
    public int pieces() {
        return pieces;
    }

    /** Writes the OBJ file; the stream is flushed but stays open. */
    public void writeTo(OutputStream stream) throws IOException {
        Writer writer = new BufferedWriter(new OutputStreamWriter(stream, StandardCharsets.US_ASCII));
        writer.write("# rays of a dronewatch run: metres, y up, north is -z\n");
        int vertex = 1;
        for (Map.Entry<String, List<Piece>> group : groups.entrySet()) {
            writer.write("g " + group.getKey() + "\n");
            double loudest =
                    Collections.max(group.getValue().stream().map(Piece::level).toList());
            int count = group.getValue().size();
            writer.write(String.format(Locale.ROOT, "# %s, the loudest %.1f dB", Counted.of(count, "segment"), loudest)
                    + LINE);
            for (Piece piece : group.getValue()) {
                double[] e = piece.ends();
                writer.write(vertex(e[0], e[1], e[2]) + vertex(e[3], e[4], e[5]));
                writer.write("l " + vertex + " " + (vertex + 1) + "\n");
                vertex += 2;
            }
        }
        writer.flush();
    }

    private static String vertex(double east, double north, double up) {
        return String.format(Locale.ROOT, "v %.4f %.4f %.4f", rounded(east), rounded(up), rounded(-north)) + LINE;
    }

    /** A length, rounded to what the file shows, without a negative zero. */
    private static double rounded(double metres) {
        return Math.round(metres * 1e4) / 1e4 + 0.0;
    }
}
