package org.dronewatch.positioner;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.OptionalInt;
import org.dronewatch.geometry.Position;

/**
 * A positioner during a run: where it points, which cues it has received, which contact it follows. Its own sensor
 * reports to it what it sees, and the sensors that cue it what they detect; both take effect from the next look on. For
 * one run and one thread.
 */
public final class Positioner {
    /**
     * Maximum age of the detections of its own camera, s; for a slow camera, 1.5 times the interval between its looks.
     */
    private static final double MAX_OWN_AGE = 0.5;

    private static final double LOOKS = 1.5;

    private record Cue(double due, int contact, Sighting sighting, double time) {}

    private final PositionerSettings settings;
    private final Position position;
    private final Direction rest;
    private final double widest;
    private final double fresh;
    private final Deque<Cue> cues = new ArrayDeque<>();

    private double time;
    private Direction direction;
    private double fov;
    private Optional<FollowedContact> track = Optional.empty();
    private Direction own;
    private double ownTime = Double.NEGATIVE_INFINITY;

    /**
     * A positioner at the start of a run.
     *
     * @param position where it stands, m
     * @param rest the direction of its sensor's own aim
     * @param widest its sensor's own field of view, rad
     * @param interval between two looks of its sensor, s
     */
    public Positioner(PositionerSettings settings, Position position, Direction rest, double widest, double interval) {
        this.settings = settings;
        this.position = position;
        this.rest = rest;
        this.widest = widest;
        this.fresh = Math.max(MAX_OWN_AGE, LOOKS * interval);
        this.own = rest;
        this.direction = settings.tilted(settings.search().at(rest, 0.0));
        this.fov = widest;
    }

    /** Whether a sensor of this name cues it. */
    public boolean isCuedBy(String sensor) {
        return settings.cues().contains(sensor);
    }

    /**
     * Records that another sensor has detected a contact.
     *
     * @param contact its number
     * @param sighting where that sensor believes it to be
     * @param detected when it detected it, s
     */
    public void cue(int contact, Sighting sighting, double detected) {
        cues.add(new Cue(detected + settings.delay(), contact, sighting, detected));
    }

    /** Records that the positioner's own sensor has seen a contact, at its last look. */
    public void see(int contact, Sighting sighting, double seen) {
        follow(contact, sighting, seen, seen);
        if (track.filter(followed -> followed.contact() == contact).isPresent()) {
            own = sighting.direction();
            ownTime = seen;
        }
    }

    private void follow(int contact, Sighting sighting, double seen, double received) {
        if (track.isEmpty()) {
            track = Optional.of(new FollowedContact(contact, sighting, seen, received));
            ownTime = Double.NEGATIVE_INFINITY;
        } else if (track.get().contact() == contact) {
            track.get().add(sighting, seen, received);
        }
    }

    /** Turns, tilts and zooms until a time, not before the last one, and returns where it then points. */
    public Pointing moveTo(double now) {
        track = track.filter(followed -> now - followed.received() <= settings.hold());
        while (!cues.isEmpty() && cues.peek().due() <= now) {
            Cue cue = cues.poll();
            if (now - cue.due() <= settings.hold()) {
                follow(cue.contact(), cue.sighting(), cue.time(), cue.due());
            }
        }
        boolean holds = track.isPresent() && now - ownTime <= fresh;
        Direction seen = own;
        Direction wanted = settings.tilted(
                track.map(followed -> holds ? seen : followed.from(position, now, settings.hold() + settings.delay()))
                        .orElseGet(() -> settings.search().at(rest, now)));
        double since = now - time;
        double turned = limited(Direction.turn(direction.azimuth(), wanted.azimuth()), settings.panSpeed() * since);
        double tilted = limited(wanted.elevation() - direction.elevation(), settings.tiltSpeed() * since);
        direction = direction.turned(turned, tilted);
        settings.zoom().ifPresent(lens -> zoom(lens, holds, since));
        time = now;
        boolean moved = since > 0.0;
        return new Pointing(
                direction,
                moved ? turned / since : 0.0,
                moved ? tilted / since : 0.0,
                fov,
                track.map(followed -> OptionalInt.of(followed.contact())).orElse(OptionalInt.empty()));
    }

    /** The field of view changes by a constant factor per second. */
    private void zoom(ZoomSettings lens, boolean holds, double since) {
        double wanted = track.isEmpty() ? widest : holds ? lens.tracked() : lens.cued();
        double narrowest = Math.min(widest, Math.min(lens.cued(), lens.tracked()));
        double span = Math.log(widest / narrowest);
        // Without a span there is nothing to limit, and a very short time would make it infinite times 0.
        double most = lens.time() > 0.0 && span > 0.0 ? since / lens.time() * span : Double.POSITIVE_INFINITY;
        fov *= Math.exp(limited(Math.log(wanted / fov), most));
    }

    private static double limited(double wanted, double most) {
        return Math.max(-most, Math.min(most, wanted));
    }
}
