package org.dronewatch.report;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.Backdrop;
import org.dronewatch.render.Fineness;
import org.dronewatch.render.Orbit;
import org.dronewatch.render.RecordedRays;
import org.dronewatch.render.SitePicture;
import org.dronewatch.render.SiteState;
import org.dronewatch.render.SiteStyle;
import org.dronewatch.render.canvas.Cut;
import org.dronewatch.report.html.Figure;
import org.dronewatch.run.AlertResult;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.DetectionIntervals;
import org.dronewatch.run.Pointings;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.Stage;

/** The site of a run at its first alert or detection: all of it, from above, and close up what is to be protected. */
final class SitePictures {
    /** A close-up that covers nearly the whole site is omitted. */
    private static final double CLOSE = 0.6;

    /** Margin around the protected zone, or around the sensors of a site without one, m. */
    private static final double LEAST_MARGIN = 15.0;

    private final RunResult run;
    private final Pointings pointings;
    private final SitePicture picture;
    private final int width;
    private final int height;
    private Optional<Backdrop> painted = Optional.empty();

    /**
     * The pictures of a run.
     *
     * @param width columns of each picture
     */
    SitePictures(RunResult run, Stage stage, Pointings pointings, int width) {
        this.run = run;
        this.pointings = pointings;
        this.picture = new SitePicture(run.settings(), stage);
        this.width = width;
        this.height = width * 3 / 5;
    }

    /** The pictures, the whole site first. */
    List<Figure> draw(String title) throws IOException {
        Optional<DetectionEvent> first = run.events().stream().findFirst();
        OptionalDouble alert = run.attackAlerts().stream()
                .map(AlertResult::time)
                .filter(OptionalDouble::isPresent)
                .mapToDouble(OptionalDouble::getAsDouble)
                .min();
        double time =
                alert.orElse(first.map(event -> event.observation().arrival()).orElse(0.0));
        DetectionIntervals intervals = DetectionIntervals.of(run.events());
        SiteState state = picture.state(
                title,
                time,
                (sensor, drone) -> intervals.isDetected(sensor, drone, time),
                sensor -> pointings.at(sensor, time),
                Optional.empty(),
                Optional.empty());
        String when = alert.isPresent()
                ? String.format(Locale.ROOT, "at the first alert, %.1f s after the start", time)
                : first.isPresent()
                        ? String.format(Locale.ROOT, "at the first detection, %.1f s after the start", time)
                        : "at the start";
        List<Figure> figures = new ArrayList<>();
        figures.add(
                figure(overview(), state, "The site " + when + ". Fields of view are not drawn to their full length."));
        figures.add(figure(Orbit.top(picture.frame(), aspect()), state, "The same from above, north up."));
        AABB near = near();
        if (near.diagonal() < CLOSE * picture.frame().diagonal()) {
            boolean zone = run.settings().alert().isProtecting();
            figures.add(figure(
                    Orbit.about(near, aspect()),
                    state,
                    (zone
                                    ? picture.protection().areas().isEmpty()
                                            ? "The protected zone"
                                            : "The protected zones"
                                    : "The sensors")
                            + " in close-up."));
        }
        return figures;
    }

    /** The protected zone and the sensors in it or near it; without a zone, all sensors. */
    private AABB near() {
        List<Position> corners = new ArrayList<>();
        run.settings().alert().protect().ifPresent(zone -> {
            double margin = Math.max(LEAST_MARGIN, zone.radius());
            Position reach = new Position(margin, margin, margin);
            corners.add(zone.centre().plus(reach));
            corners.add(zone.centre().minus(reach));
            run.settings().enabledSensors().values().stream()
                    .map(sensor -> sensor.position())
                    .filter(at -> zone.distance(at) <= 2.0 * margin)
                    .forEach(corners::add);
        });
        picture.protection().areas().forEach(area -> area.outline().forEach(corner -> {
            corners.add(new Position(corner.x() - LEAST_MARGIN, corner.y() - LEAST_MARGIN, area.bottom()));
            corners.add(new Position(corner.x() + LEAST_MARGIN, corner.y() + LEAST_MARGIN, area.top()));
        }));
        if (corners.isEmpty()) {
            Position margin = new Position(LEAST_MARGIN, LEAST_MARGIN, LEAST_MARGIN);
            run.settings().enabledSensors().values().forEach(sensor -> {
                corners.add(sensor.position().plus(margin));
                corners.add(sensor.position().minus(margin));
            });
        }
        return corners.isEmpty() ? picture.frame() : AABB.around(corners);
    }

    /**
     * The whole site with the rays of sound from a drone to a sensor.
     *
     * @param time when they left the drone
     * @param detected whether they were detected
     */
    Figure ofRays(
            String title, String sensor, String drone, double time, boolean detected, RecordedRays rays, String caption)
            throws IOException {
        SiteState state = picture.state(
                title,
                time,
                (one, other) -> detected && one.equals(sensor) && other.equals(drone),
                one -> pointings.at(one, time),
                Optional.of(sensor),
                Optional.of(rays));
        return figure(overview(), state, caption);
    }

    private double aspect() {
        return (double) width / height;
    }

    private Orbit overview() {
        return Orbit.about(picture.frame(), aspect());
    }

    private Figure figure(Orbit orbit, SiteState state, String caption) throws IOException {
        return Figure.of(
                caption, picture.draw(backdrop(orbit, picture.openRoof(state.time())), state, SiteStyle.DEFAULT));
    }

    /** The site from a viewpoint; the first one is painted once for all pictures from there. */
    private Backdrop backdrop(Orbit orbit, Optional<Cut> cut) {
        Optional<Backdrop> known =
                painted.filter(one -> one.orbit().equals(orbit) && one.cut().equals(cut));
        Backdrop backdrop =
                known.orElseGet(() -> picture.backdrop(orbit, width, height, cut, Fineness.FINE, () -> false));
        painted = Optional.of(painted.orElse(backdrop));
        return backdrop;
    }
}
