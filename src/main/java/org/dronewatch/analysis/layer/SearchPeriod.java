package org.dronewatch.analysis.layer;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.positioner.Positioner;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.Outlined;
import org.dronewatch.sensor.SensorSettings;

/**
 * Where a sensor on a positioner points during one period of its search, while nothing cues it: at times that are
 * evenly spaced, close enough together that its field of view moves by at most a quarter of itself between two of them,
 * or by 1/20,000 of its path. A positioner without a search rests. Immutable.
 */
final class SearchPeriod {
    private static final int LEAST = 720;
    private static final int MOST = 20_000;
    private static final double PER_FIELD_OF_VIEW = 4.0;

    private final Position position;
    private final List<Pointing> pointings;

    /** The field of view at each of them; empty for a sensor that has none. */
    private final List<Optional<Outline>> outlines = new ArrayList<>();

    private final Optional<LookWindow> window;

    private SearchPeriod(SensorSettings<?> sensor, List<Pointing> pointings, Optional<LookWindow> window) {
        this.position = sensor.position();
        this.pointings = pointings;
        this.window = window;
        pointings.forEach(one -> outlines.add(Outlined.fieldOfView(sensor, Optional.of(one))));
    }

    /**
     * The search of a sensor; empty on a fixed mount.
     *
     * @param terms with the time that it has, if it has more than one look
     */
    static Optional<SearchPeriod> of(SensorSettings<?> sensor, FieldTerms terms) {
        Optional<PositionerSettings> positioner = Mounted.positioner(sensor);
        if (positioner.isEmpty()) {
            return Optional.empty();
        }
        double period = positioner.get().search().period();
        if (period == 0.0) {
            return Optional.of(new SearchPeriod(sensor, List.of(start(sensor).moveTo(0.0)), Optional.empty()));
        }
        List<Pointing> coarse = pointings(start(sensor), period, LEAST);
        double path = 0.0;
        double narrowest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < LEAST; i++) {
            Position next = coarse.get((i + 1) % LEAST).direction().unit();
            path += coarse.get(i).direction().unit().angle(next);
            narrowest = Math.min(narrowest, coarse.get(i).fov());
        }
        int count = (int) Math.max(LEAST, Math.min(MOST, Math.ceil(PER_FIELD_OF_VIEW * path / narrowest)));
        return Optional.of(new SearchPeriod(
                sensor, pointings(start(sensor), period, count), LookWindow.of(terms, sensor, period, count)));
    }

    private static Positioner start(SensorSettings<?> sensor) {
        return sensor.as(Mounted.class).flatMap(Mounted::createPositioner).orElseThrow();
    }

    /** The directions in the second period: in the first one, the positioner may still be on its way to the pattern. */
    private static List<Pointing> pointings(Positioner positioner, double period, int count) {
        List<Pointing> all = new ArrayList<>();
        for (int i = 0; i < 2 * count; i++) {
            Pointing now = positioner.moveTo(period * i / count);
            if (i >= count) {
                all.add(now);
            }
        }
        return all;
    }

    /** The looks within the time that the sensor has; empty if it has a single look, or rests. */
    Optional<LookWindow> window() {
        return window;
    }

    /**
     * The pointings that may show a drone.
     *
     * @param at its position, m
     * @param radius of a sphere around it that holds it, m
     */
    CellPointings at(Position at, double radius) {
        Position vector = at.minus(position);
        List<Optional<Pointing>> towards = new ArrayList<>();
        List<Integer> passes = new ArrayList<>();
        List<Integer> phases = new ArrayList<>();
        Optional<Pointing> away = Optional.empty();
        boolean wasInView = false;
        for (int i = 0; i < pointings.size(); i++) {
            Optional<Outline> outline = outlines.get(i);
            boolean isInView = outline.isEmpty() || outline.get().mayShow(vector, radius);
            if (isInView && !wasInView) {
                passes.add(towards.size());
            }
            if (isInView) {
                towards.add(Optional.of(pointings.get(i)));
                phases.add(i);
            } else {
                away = away.isEmpty() ? Optional.of(pointings.get(i)) : away;
            }
            wasInView = isInView;
        }
        return new CellPointings(towards, passes, phases, (double) towards.size() / pointings.size(), away);
    }
}
