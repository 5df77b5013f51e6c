package org.dronewatch.run;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.dronewatch.positioner.Pointing;

/** Remembers where the mounts of a run's sensors pointed. One thread at a time. */
public final class Pointings {
    private final Map<String, TreeMap<Double, Pointing>> known = new HashMap<>();
    private final double interval;

    /** Remembers every look. */
    public Pointings() {
        this(0.0);
    }

    /**
     * Remembers the last look of each interval, so that memory stays in bounds: {@link #at} is exact at whole multiples of it.
     *
     * @param interval s; 0 for every look
     */
    public Pointings(double interval) {
        this.interval = interval;
    }

    /** Takes the pointings of a frame. */
    public void add(Frame frame) {
        frame.pointings()
                .forEach((sensor, pointing) ->
                        add(known.computeIfAbsent(sensor, name -> new TreeMap<>()), frame.time(), pointing));
    }

    private void add(TreeMap<Double, Pointing> looks, double time, Pointing pointing) {
        if (interval > 0.0 && !looks.isEmpty() && index(looks.lastKey()) == index(time)) {
            looks.pollLastEntry();
        }
        looks.put(time, pointing);
    }

    /** The interval that ends with its own multiple. */
    private long index(double time) {
        return (long) Math.ceil(time / interval);
    }

    /** Where the mount of a sensor pointed at its last look up to a time, s; empty for a sensor that stands still. */
    public Optional<Pointing> at(String sensor, double time) {
        return Optional.ofNullable(known.get(sensor))
                .flatMap(looks -> Optional.ofNullable(looks.floorEntry(time)))
                .map(Map.Entry::getValue);
    }
}
