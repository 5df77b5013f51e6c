package org.dronewatch.report;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import org.dronewatch.run.Frame;
import org.dronewatch.run.SceneResult;
import org.dronewatch.sensor.Observation;

/** Plots of each sensor's measured values versus range, with its threshold: they show the margin of each decision. */
final class RangePlots {
    /** Maximum number of points of a plot; later ones are omitted. */
    private static final int MAX_POINTS = 200_000;

    private final Map<String, Map<Subject, RangeCurve>> sensors = new LinkedHashMap<>();
    private int points;

    private record Subject(int run, String drone) {}

    void add(Frame frame) {
        for (Observation observation : frame.ofDrones()) {
            // Minus infinity is the level of silence: nothing to draw.
            if (points < MAX_POINTS && Double.isFinite(observation.value())) {
                points++;
                sensors.computeIfAbsent(observation.sensor(), name -> new LinkedHashMap<>())
                        .computeIfAbsent(
                                new Subject(frame.run(), observation.drone()),
                                subject -> new RangeCurve(frame.run(), observation))
                        .add(observation);
            }
        }
    }

    /**
     * Writes a plot for each sensor.
     *
     * @param files returns the file of a plot, by the name of its sensor and its caption
     */
    void write(SceneResult result, BiFunction<String, String, Path> files) {
        sensors.keySet().forEach(sensor -> {
            RangePlot plot = plot(result, sensor);
            Charts.write(plot.chart(), files.apply(sensor, plot.caption()));
        });
    }

    /** The plot of a sensor that has measured something. */
    RangePlot plot(SceneResult result, String sensor) {
        return new RangePlot(result, sensor, distinct(sensors.get(sensor).values()));
    }

    /** Curves that are the same in several runs are drawn once. */
    private static List<RangeCurve> distinct(Iterable<RangeCurve> curves) {
        List<RangeCurve> distinct = new ArrayList<>();
        for (RangeCurve curve : curves) {
            distinct.stream()
                    .filter(curve::isLike)
                    .findFirst()
                    .ifPresentOrElse(other -> other.addRunsOf(curve), () -> distinct.add(curve));
        }
        return distinct;
    }
}
