package org.dronewatch.render;

import java.awt.Color;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronewatch.render.canvas.FlightStretch;
import org.dronewatch.render.canvas.Symbols;
import org.dronewatch.render.canvas.WatcherColours;

/** The flights of a picture that are coloured by which sensors detect the drone. */
final class WatchedFlights {
    /** The dashes of flights that no sensor detects, as a fraction of the box of interest. */
    private static final double DASH = 0.012;

    /** The number of changes along flights that are written beside them. */
    private static final int MOST_NOTES = 12;

    private final List<FlightStretch> stretches;
    private final WatcherColours watchers;
    private final Set<String> drones;

    WatchedFlights(List<FlightStretch> stretches) {
        this.stretches = stretches;
        this.watchers = new WatcherColours(stretches);
        this.drones = stretches.stream().map(FlightStretch::drone).collect(Collectors.toSet());
    }

    /** Whether the flight of a drone is among them. */
    boolean has(String drone) {
        return drones.contains(drone);
    }

    /** What the colours mean. */
    Map<String, Color> legend() {
        return watchers.legend();
    }

    /**
     * Draws the lines.
     *
     * @param size size of the box of interest, m
     */
    void draw(StateLines lines, double size) {
        lines.stretches(stretches, watchers, DASH * size);
    }

    /** Writes beside them which sensors detect the drone from there on; the beginning of a flight needs no words. */
    void write(Symbols symbols) {
        stretches.stream()
                .filter(stretch -> stretch.from() > 0.0)
                .limit(MOST_NOTES)
                .forEach(stretch -> symbols.note(
                        stretch.path().get(0),
                        String.format(
                                Locale.ROOT, "%.1f s: %s", stretch.from(), WatcherColours.names(stretch.sensors()))));
    }
}
