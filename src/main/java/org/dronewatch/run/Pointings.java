package org.dronewatch.run;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.dronewatch.positioner.Pointing;

/** A record of where the positioners of a run's sensors pointed. Not thread-safe. */
public final class Pointings {
    private final Map<String, TreeMap<Double, Pointing>> known = new HashMap<>();
    private final double interval;

    /** A record of the pointings at every look. */
    public Pointings() {
        this(0.0);
    }

    /**
     * A record of the pointings at the last look in each interval, so that memory stays bounded: {@link #at} is exact
     * at whole multiples of the interval.
     *
     * @param interval the interval, s; 0 for every look
     */
    public Pointings(double interval) {
        this.interval = interval;
    }

    /** Adds the pointings of a frame. */
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

    /** The index of the interval, which ends at a multiple of its length. */
    private long index(double time) {
        return (long) Math.ceil(time / interval);
    }

    /**
     * Where the positioner of a sensor pointed at its last look at or before a time, s; empty for a sensor on a fixed
     * mount.
     */
    public Optional<Pointing> at(String sensor, double time) {
        return Optional.ofNullable(known.get(sensor))
                .flatMap(looks -> Optional.ofNullable(looks.floorEntry(time)))
                .map(Map.Entry::getValue);
    }
}
