package org.dronewatch.flight.mission;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.dronewatch.flight.file.DroneSpeeds;
import org.dronewatch.geo.EarthPlace;
import org.dronewatch.geo.EarthPoint;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.Places;

/** Finds the positions on a site to which the steps of a mission lead. For a single use. */
final class MissionRoute {
    /**
     * Up to this difference between the heights of the launch position in the plan and on the site, no warning is
     * given, m.
     */
    private static final double ODD = 20.0;

    /** Points nearer to each other than this count as the same, m. */
    private static final double SAME = 1e-3;

    private final Mission settings;
    private final PlanFile plan;
    private final Places places;
    private final Consumer<String> warnings;
    private final MissionLegs legs;
    private double speed;
    private OptionalDouble launch = OptionalDouble.empty();
    /** The position of the drone after the steps so far; empty before the first. */
    private Optional<Position> here = Optional.empty();

    /**
     * A route.
     *
     * @param drone the drone's speeds and acceleration, which apply where neither the plan nor the settings state any
     */
    MissionRoute(Mission settings, PlanFile plan, Places places, DroneSpeeds drone, Consumer<String> warnings) {
        this.settings = settings;
        this.plan = plan;
        this.places = places;
        this.warnings = warnings;
        this.speed = plan.speed().orElse(drone.cruise());
        this.legs = new MissionLegs(
                drone.acceleration(),
                settings.climbRate().orElse(drone.climb()),
                settings.descentRate().orElse(drone.sink()),
                places);
    }

    MissionPath path() {
        boolean over = false;
        int left = 0;
        for (MissionStep step : plan.steps()) {
            if (over) {
                left++;
            } else {
                take(step);
                over = step instanceof MissionStep.Stay;
            }
        }
        if (left > 0) {
            warnings.accept(settings.plan() + ": " + left + (left == 1 ? " step comes" : " steps come")
                    + " after an item at which the drone stays, and " + (left == 1 ? "is" : "are") + " never reached");
        }
        return legs.path(here.orElseThrow(
                () -> new IllegalArgumentException(settings.plan() + ": the mission has no take-off and no waypoint")));
    }

    private void take(MissionStep step) {
        if (step instanceof MissionStep.TakeOff up) {
            takeOff(up);
        } else if (step instanceof MissionStep.FlyTo to) {
            flyTo(to);
        } else if (step instanceof MissionStep.Land down) {
            land(down.where(), down.place());
        } else if (step instanceof MissionStep.TouchDown down) {
            Position spot = placing(down.where(), () -> onSurface(down.place()));
            legs.to(spot, speed, OptionalDouble.empty());
            here = Optional.of(spot);
        } else if (step instanceof MissionStep.Return back) {
            land(back.where(), Optional.of(home(back.where())));
        } else if (step instanceof MissionStep.Wait wait) {
            legs.hold(wait.seconds());
        } else if (step instanceof MissionStep.Speed other) {
            speed = other.speed();
        }
    }

    /**
     * Climbs straight up at home, and then flies level to the place. A real fixed-wing aircraft climbs at an angle
     * instead, but soon reaches the same height.
     */
    private void takeOff(MissionStep.TakeOff up) {
        EarthPoint start = here.isEmpty() ? home(up.where()) : null;
        if (start != null) {
            here = Optional.of(placing(up.where(), () -> onSurface(start)));
            legs.begin(here.get());
            move(up.where(), start, up.height());
        }
        up.place().ifPresent(place -> move(up.where(), place, up.height()));
    }

    private void flyTo(MissionStep.FlyTo to) {
        move(to.where(), to.place(), to.height());
        legs.hold(to.hold());
    }

    private void move(String where, EarthPoint place, MissionStep.Height height) {
        Position target = placing(where, () -> position(place, height));
        if (here.isEmpty()) {
            legs.begin(target);
        }
        boolean follows = height.frame() == MissionStep.Frame.SURFACE;
        legs.to(target, speed, follows ? OptionalDouble.of(height.metres()) : OptionalDouble.empty());
        here = Optional.of(target);
    }

    private void land(String where, Optional<EarthPoint> place) {
        Position from = here.orElseThrow(
                () -> new IllegalArgumentException(at(where) + "a landing without a flight before it"));
        Position spot =
                place.map(point -> placing(where, () -> onSurface(point))).orElseGet(() -> below(where, from));
        Position over = new Position(spot.x(), spot.y(), Math.max(from.z(), spot.z()));
        if (over.distance(from) > SAME) {
            legs.to(over, speed, OptionalDouble.empty());
        }
        legs.to(spot, speed, OptionalDouble.empty());
        here = Optional.of(spot);
    }

    private Position below(String where, Position from) {
        OptionalDouble z = places.ground().height(from.x(), from.y());
        return new Position(
                from.x(),
                from.y(),
                z.orElseThrow(() -> new IllegalArgumentException(String.format(
                        Locale.ROOT,
                        "%sno surface to land on at x %.1f m, y %.1f m: the site has a hole or ends there",
                        at(where),
                        from.x(),
                        from.y()))));
    }

    private EarthPoint home(String where) {
        return plan.home()
                .orElseThrow(() -> new IllegalArgumentException(
                        at(where) + "needs mission.plannedHomePosition, the launch position"));
    }

    private Position onSurface(EarthPoint point) {
        OptionalDouble height = places.surface(point.latitude(), point.longitude());
        if (height.isEmpty() && plan.home().equals(Optional.of(point))) {
            return places.atHeight(point.latitude(), point.longitude(), launchHeight());
        }
        return places.at(new EarthPlace(point.latitude(), point.longitude(), Optional.of(0.0), Optional.empty()));
    }

    private Position position(EarthPoint place, MissionStep.Height height) {
        double latitude = place.latitude();
        double longitude = place.longitude();
        return switch (height.frame()) {
            case SEA -> places.at(new EarthPlace(latitude, longitude, Optional.empty(), Optional.of(height.metres())));
            case HOME -> places.atHeight(latitude, longitude, launchHeight() + height.metres());
            case SURFACE ->
                places.atHeight(
                        latitude,
                        longitude,
                        places.surface(latitude, longitude)
                                        .orElseThrow(
                                                () -> new IllegalArgumentException(
                                                        "no surface at "
                                                                + Places.inWords(latitude, longitude)
                                                                + " from which to measure the height: the site has a hole or ends there"))
                                + height.metres());
        };
    }

    /**
     * The level from which relative heights are measured: that of the site at the launch position, or else that stated
     * in the plan.
     */
    private double launchHeight() {
        if (launch.isEmpty()) {
            launch = OptionalDouble.of(foundLaunchHeight());
        }
        return launch.getAsDouble();
    }

    private double foundLaunchHeight() {
        EarthPoint home = plan.home()
                .orElseThrow(() -> new IllegalArgumentException(
                        "heights above the launch position need mission.plannedHomePosition"));
        OptionalDouble ground = places.surface(home.latitude(), home.longitude());
        OptionalDouble planned = places.heightsAreKnown() ? plan.homeHeight() : OptionalDouble.empty();
        if (ground.isEmpty()) {
            double height = planned.orElseThrow(
                    () -> new IllegalArgumentException(
                            "no surface at " + Places.inWords(home.latitude(), home.longitude())
                                    + ", the launch position, from which to measure heights: the site has a hole or ends there"));
            warnings.accept(String.format(
                    Locale.ROOT,
                    "%s: the launch position is in a hole of the site or beyond its edge: heights are measured from %.1f m above sea level, as the plan states",
                    settings.plan(),
                    height));
            return height;
        }
        if (planned.isPresent() && Math.abs(planned.getAsDouble() - ground.getAsDouble()) > ODD) {
            warnings.accept(String.format(
                    Locale.ROOT,
                    "%s: the launch position is %.1f m above sea level in the plan, %.1f m on the site: heights are measured from the site",
                    settings.plan(),
                    planned.getAsDouble(),
                    ground.getAsDouble()));
        }
        return ground.getAsDouble();
    }

    private interface Placing {
        Position position();
    }

    private Position placing(String where, Placing placing) {
        try {
            return placing.position();
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(at(where) + e.getMessage(), e);
        }
    }

    private String at(String where) {
        return settings.plan() + ": " + where + ": ";
    }
}
