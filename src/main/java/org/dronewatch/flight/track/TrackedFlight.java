package org.dronewatch.flight.track;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.flight.FlightState;
import org.dronewatch.flight.Leg;
import org.dronewatch.flight.file.DroneSpeeds;
import org.dronewatch.flight.file.FlightSource;
import org.dronewatch.geo.EarthPlace;
import org.dronewatch.geo.EarthPoint;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.world.Places;

/** A track as it was read. */
final class TrackedFlight implements FlightSource {
    /** A speed greater than any drone's, m/s: a faster jump is an error of the receiver. */
    private static final double FASTEST = 400.0;

    /** Below this speed, the nose keeps its heading, m/s. */
    private static final double STILL = 0.05;

    private final Track settings;
    private final String name;
    private final Fixes.Points points;
    private final FileHash hash;

    TrackedFlight(Track settings, Fixes.Points points, byte[] bytes) {
        this.settings = settings;
        this.name = PlainText.value(settings.log());
        this.points = points;
        try {
            this.hash = FileHash.of(settings.log(), new ByteArrayInputStream(bytes));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        checkHeights();
    }

    private void checkHeights() {
        for (Fixes.Fix fix : points.fixes()) {
            if (fix.height().isEmpty() && settings.heights() != Track.Heights.SURFACE) {
                throw new InputException(name + ":" + fix.line()
                        + ": has no height: with 'heights: surface' and a 'verticalOffset' the drone flies at"
                        + " that height above the surface");
            }
        }
    }

    @Override
    public FileHash hash() {
        return hash;
    }

    @Override
    public String description() {
        List<Fixes.Fix> fixes = points.fixes();
        String span = points.isTimed()
                ? String.format(
                        Locale.ROOT,
                        "in %.1f s",
                        fixes.get(fixes.size() - 1).time() - fixes.get(0).time())
                : "without times";
        String notes = points.notes().isEmpty() ? "" : "; " + String.join("; ", points.notes());
        return name + ": " + fixes.size() + (fixes.size() == 1 ? " point " : " points ") + span + notes;
    }

    @Override
    public FlightPath path(Places places, DroneSpeeds drone, Consumer<String> warnings) {
        double launch = settings.heights() == Track.Heights.START ? launch(places) : 0.0;
        List<Position> positions = new ArrayList<>();
        for (Fixes.Fix fix : points.fixes()) {
            positions.add(position(fix, places, launch));
        }
        if (points.isTimed()) {
            return new LoggedPath(legs(positions));
        }
        warnings.accept(name + ": has no times: the drone flies through its points at its own speed");
        List<Position> apart = apart(positions);
        return apart.size() == 1
                ? FlightPathSettings.Hover.at(apart.get(0))
                        .create(drone.cruise(), drone.acceleration(), places.ground())
                : waypoints(apart, drone, places);
    }

    private FlightPath waypoints(List<Position> apart, DroneSpeeds drone, Places places) {
        if (apart.size() > FlightPathSettings.MOST_WAYPOINTS) {
            throw new IllegalArgumentException(name + ": has " + apart.size()
                    + " points without times but must have at most " + FlightPathSettings.MOST_WAYPOINTS);
        }
        return new FlightPathSettings.Waypoints(apart).create(drone.cruise(), drone.acceleration(), places.ground());
    }

    private static List<Position> apart(List<Position> positions) {
        List<Position> apart = new ArrayList<>();
        for (Position position : positions) {
            if (apart.isEmpty() || apart.get(apart.size() - 1).distance(position) >= FlightPathSettings.SHORTEST) {
                apart.add(position);
            }
        }
        return apart;
    }

    /**
     * The offset that must be added to the heights in the file to refer them to the level of the origin's height, m.
     */
    private double launch(Places places) {
        Fixes.Fix first = points.fixes().get(0);
        EarthPoint place = first.place();
        OptionalDouble surface = placed(first, () -> places.surface(place.latitude(), place.longitude()));
        return surface.orElseThrow(() -> new IllegalArgumentException(at(first) + "no surface at "
                        + Places.inWords(place.latitude(), place.longitude())
                        + " from which to measure heights: the site has a hole or ends there"))
                - first.height().getAsDouble();
    }

    private Position position(Fixes.Fix fix, Places places, double launch) {
        EarthPoint place = fix.place();
        double height = fix.height().orElse(0.0) + settings.verticalOffset();
        return placed(fix, () -> switch (settings.heights()) {
            case SEA ->
                places.at(new EarthPlace(place.latitude(), place.longitude(), Optional.empty(), Optional.of(height)));
            case START -> places.atHeight(place.latitude(), place.longitude(), launch + height);
            case SURFACE -> places.atHeight(place.latitude(), place.longitude(), surface(place, places) + height);
        });
    }

    private static double surface(EarthPoint place, Places places) {
        return places.surface(place.latitude(), place.longitude())
                .orElseThrow(() -> new IllegalArgumentException(
                        "no surface at " + Places.inWords(place.latitude(), place.longitude())
                                + " from which to measure the height: the site has a hole or ends there"));
    }

    private List<Leg> legs(List<Position> positions) {
        List<Fixes.Fix> fixes = points.fixes();
        List<Leg> legs = new ArrayList<>();
        double begin = fixes.get(0).time();
        double heading = 0.0;
        for (int i = 0; i < positions.size() - 1; i++) {
            Fixes.Fix next = fixes.get(i + 1);
            double lasts = next.time() - fixes.get(i).time();
            Position velocity = positions.get(i + 1).minus(positions.get(i)).times(1.0 / lasts);
            if (!(velocity.length() <= FASTEST)) {
                throw new IllegalArgumentException(String.format(
                        Locale.ROOT,
                        "%sis reached at %.0f m/s from line %d, but at most %.0f m/s is possible: delete points where the receiver had no fix",
                        at(next),
                        velocity.length(),
                        fixes.get(i).line(),
                        FASTEST));
            }
            if (Math.hypot(velocity.x(), velocity.y()) > STILL) {
                heading = Math.atan2(velocity.x(), velocity.y());
            }
            legs.add(new Leg(fixes.get(i).time() - begin, new FlightState(positions.get(i), velocity, heading)));
        }
        Position end = positions.get(positions.size() - 1);
        double last = fixes.get(fixes.size() - 1).time() - begin;
        legs.add(new Leg(last, new FlightState(end, new Position(0, 0, 0), heading)));
        return legs;
    }

    private interface Placing<T> {
        T find();
    }

    private <T> T placed(Fixes.Fix fix, Placing<T> placing) {
        try {
            return placing.find();
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(at(fix) + e.getMessage(), e);
        }
    }

    private String at(Fixes.Fix fix) {
        return name + ":" + fix.line() + ": ";
    }
}
