package org.dronewatch.positioner;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.OptionalInt;
import org.dronewatch.geometry.Position;

/**
 * A positioner during a run, with its direction, its cues and the contact that it follows. Sightings by its own sensor
 * and detections by the sensors that cue it take effect from the next look on. For one run, and for use by one thread.
 */
public final class Positioner {
    /**
     * Maximum age of the detections of its own camera, s; for a slow camera, 1.5 times the interval between its looks.
     */
    private static final double MAX_OWN_AGE = 0.5;

    private static final double LOOKS = 1.5;

    /** A field of view has to cover this number of standard errors of a direction to either side. */
    private static final double DEVIATIONS = 2.0;

    /** The positioner has turned to a direction if it points to within this angle of it, rad. */
    private static final double TURNED = 1e-9;

    /** The positioner has zoomed to a field of view if its own is at most this many times as wide. */
    private static final double ZOOMED = 1.05;

    private record Cue(double due, int contact, Sighting sighting, double time) {}

    private final PositionerSettings settings;
    private final Position position;
    private final Direction rest;
    private final double widest;
    private final ImageShape shape;
    private final double fresh;
    private final RangeScan scan;
    private final Deque<Cue> cues = new ArrayDeque<>();

    private double time;
    private Direction direction;
    private double fov;
    private Optional<FollowedContact> track = Optional.empty();
    private Direction own;
    private double ownTime = Double.NEGATIVE_INFINITY;

    /**
     * A positioner at the start of a run, for a sensor with a square image.
     *
     * @param position position of the positioner, m
     * @param rest the direction of the aim in its sensor's settings
     * @param widest its sensor's own field of view, rad
     * @param interval time between two looks of its sensor, s
     */
    public Positioner(PositionerSettings settings, Position position, Direction rest, double widest, double interval) {
        this(settings, position, rest, widest, ImageShape.SQUARE, interval);
    }

    /**
     * A positioner at the start of a run.
     *
     * @param position position of the positioner, m
     * @param rest the direction of the aim in its sensor's settings
     * @param widest its sensor's own field of view, rad
     * @param shape proportions of its sensor's image
     * @param interval time between two looks of its sensor, s
     */
    public Positioner(
            PositionerSettings settings,
            Position position,
            Direction rest,
            double widest,
            ImageShape shape,
            double interval) {
        this.settings = settings;
        this.position = position;
        this.rest = rest;
        this.widest = widest;
        this.shape = shape;
        this.scan = new RangeScan(settings, position, shape, interval);
        this.fresh = Math.max(MAX_OWN_AGE, LOOKS * interval);
        this.own = rest;
        this.direction = settings.tilted(settings.search().at(rest, 0.0));
        this.fov = widest;
    }

    /** Whether the sensor with this name cues this positioner. */
    public boolean isCuedBy(String sensor) {
        return settings.cues().contains(sensor);
    }

    /**
     * Records that another sensor has detected a contact.
     *
     * @param contact number of the contact
     * @param sighting the position or direction that the sensor estimated
     * @param detected time at which that sensor detected the contact, s
     */
    public void cue(int contact, Sighting sighting, double detected) {
        cues.add(new Cue(detected + settings.delay(), contact, sighting, detected));
    }

    /**
     * Records that the positioner's own sensor has seen a contact at its most recent look, at the time {@code seen}, s.
     */
    public void see(int contact, Sighting sighting, double seen) {
        follow(contact, sighting, seen, seen);
        if (track.filter(followed -> followed.contact() == contact).isPresent()) {
            own = sighting.direction();
            ownTime = seen;
        }
    }

    private void follow(int contact, Sighting sighting, double seen, double received) {
        if (track.isEmpty()) {
            track = Optional.of(new FollowedContact(contact, sighting, seen, received, settings));
            ownTime = Double.NEGATIVE_INFINITY;
            scan.reset();
        } else if (track.get().contact() == contact) {
            track.get().add(sighting, seen, received);
        }
    }

    /**
     * Pans, tilts and zooms until a time, s, which must not be before the previous one, and returns the pointing then.
     */
    public Pointing moveTo(double now) {
        track = track.filter(followed -> now - followed.received() <= settings.hold());
        while (!cues.isEmpty() && cues.peek().due() <= now) {
            Cue cue = cues.poll();
            if (now - cue.due() <= settings.hold()) {
                follow(cue.contact(), cue.sighting(), cue.time(), cue.due());
            }
        }
        boolean holds = track.isPresent() && now - ownTime <= fresh;
        Optional<Direction> known = holds ? Optional.of(own) : predicted(now);
        Optional<BearingLine> line = track.filter(followed -> known.isEmpty()).map(followed -> followed.line(now));
        double field = wantedField(holds, line);
        Direction wanted = settings.tilted(known.or(() -> line.map(searched -> scan.at(searched, now, field)))
                .orElseGet(() -> settings.search().at(rest, now)));
        double since = now - time;
        double turned = limited(Direction.turn(direction.azimuth(), wanted.azimuth()), settings.panSpeed() * since);
        double tilted = limited(wanted.elevation() - direction.elevation(), settings.tiltSpeed() * since);
        direction = direction.turned(turned, tilted);
        settings.zoom().ifPresent(lens -> zoom(lens, field, since));
        if (line.isEmpty()) {
            scan.reset();
        } else if (direction.unit().distance(wanted.unit()) <= TURNED && fov <= ZOOMED * field) {
            scan.arrive(now);
        }
        time = now;
        boolean moved = since > 0.0;
        return new Pointing(
                direction,
                moved ? turned / since : 0.0,
                moved ? tilted / since : 0.0,
                fov,
                track.map(followed -> OptionalInt.of(followed.contact())).orElse(OptionalInt.empty()));
    }

    /** The direction to the predicted position of the contact; empty if no position is known. */
    private Optional<Direction> predicted(double now) {
        return track.flatMap(followed -> followed.position(now))
                .map(place -> place.minus(position))
                .filter(offset -> offset.length() > 0.0)
                .map(Direction::of);
    }

    /**
     * The field of view for a contact as stated in the positioner's settings, but wide enough for the error of a line,
     * rad.
     */
    private double wantedField(boolean holds, Optional<BearingLine> line) {
        if (settings.zoom().isEmpty() || track.isEmpty()) {
            return widest;
        }
        ZoomSettings lens = settings.zoom().get();
        double error = line.map(BearingLine::error).orElse(0.0);
        double fitting = shape.fitting(Math.min(Math.PI / 2, 2.0 * DEVIATIONS * error));
        return holds ? lens.tracked() : Math.min(widest, Math.max(lens.cued(), fitting));
    }

    /** Zooms towards a field of view, which changes by a constant factor per second. */
    private void zoom(ZoomSettings lens, double wanted, double since) {
        double narrowest = Math.min(widest, Math.min(lens.cued(), lens.tracked()));
        double span = Math.log(widest / narrowest);
        // If there is no span, there is nothing to limit, and a very short time would lead to infinity times 0.
        double most = lens.time() > 0.0 && span > 0.0 ? since / lens.time() * span : Double.POSITIVE_INFINITY;
        fov *= Math.exp(limited(Math.log(wanted / fov), most));
    }

    private static double limited(double wanted, double most) {
        return Math.max(-most, Math.min(most, wanted));
    }
}
