package org.dronewatch.render;

import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import org.dronewatch.drone.Drone;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.render.canvas.Canvas;
import org.dronewatch.render.canvas.Cut;
import org.dronewatch.render.canvas.DroneMark;
import org.dronewatch.render.canvas.Flights;
import org.dronewatch.render.canvas.KindColours;
import org.dronewatch.render.canvas.LinePainter;
import org.dronewatch.render.canvas.SensorMark;
import org.dronewatch.render.canvas.Symbols;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.Outlined;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;
import org.dronewatch.world.WorldSettings;

/**
 * Draws pictures of a run's site: first a backdrop of the site alone, which takes longest and is the same at all times,
 * then, over a copy of it, the state at one time. Lines are hidden by surfaces in front of them. One picture at a time.
 */
public final class SitePicture {
    /** How far the frustums of cameras are drawn, as a fraction of the framed box. */
    private static final double OUTLINE = 0.16;

    /** The elevation from which on a view from afar counts as one from above, rad. */
    private static final double STEEP = 1.5;

    private final SitePainter painter;
    private final KindColours colours;
    private final SceneSettings settings;
    private final Set<String> drones;
    private final Stage stage;
    private final World world;
    private final Flights flights;
    private final Protection protection;
    private final RayLayer rayLayer = new RayLayer();
    private final SkinLayer skinLayer;

    /** Pictures of one run of a scene. */
    public SitePicture(SceneSettings settings, Stage stage) {
        this.settings = settings;
        this.stage = stage;
        this.drones = settings.individualDrones().keySet();
        this.world = stage.world();
        this.protection = stage.protection();
        this.painter = new SitePainter(world, stage.colours());
        this.skinLayer = new SkinLayer(painter.facets());
        this.colours = KindColours.of(settings.enabledSensors().values());
        this.flights = new Flights(settings, stage);
    }

    /**
     * The state of the site at a time.
     *
     * @param title title of the picture
     * @param time seconds since the start of the run
     * @param detects whether the sensor with the first name detects the drone with the second name at that time
     * @param pointing where the positioner of the sensor with a given name points at that time; empty for a fixed mount
     * @param selected the sensor or drone that is emphasised
     * @param rays rays of sound
     */
    public SiteState state(
            String title,
            double time,
            BiPredicate<String, String> detects,
            Function<String, Optional<Pointing>> pointing,
            Optional<String> selected,
            Optional<RecordedRays> rays) {
        Set<String> sensors = settings.enabledSensors().keySet();
        List<SensorMark> sensorMarks = new ArrayList<>();
        settings.enabledSensors()
                .forEach((id, sensor) -> sensorMarks.add(new SensorMark(
                        id,
                        sensor.kind(),
                        sensor.position(),
                        Outlined.outline(Mounted.pointed(sensor, pointing.apply(id))),
                        drones.stream().anyMatch(drone -> detects.test(id, drone)))));
        List<DroneMark> droneMarks = stage.dronesAt(time).stream()
                .map(drone -> flights.mark(
                        drone, time, sensors.stream().anyMatch(sensor -> detects.test(sensor, drone.id()))))
                .toList();
        return new SiteState(title, time, sensorMarks, droneMarks, selected, rays);
    }

    /** The box of interest, m: all sensors and all flights, with a margin; without a flight, also the whole site. */
    public AABB interest() {
        if (!drones.isEmpty()) {
            return flights.interest(settings);
        }
        return settings.enabledSensors().isEmpty()
                ? world.bounds()
                : world.bounds().union(flights.interest(settings));
    }

    /**
     * The box that a picture of the site frames, m: the box of interest, enlarged to include the protected zones and
     * the cameras' fields of view, up to the length to which these are drawn.
     */
    public AABB frame() {
        AABB interest = interest();
        List<Position> corners = new ArrayList<>();
        corners.add(new Position(interest.minX(), interest.minY(), interest.minZ()));
        corners.add(new Position(interest.maxX(), interest.maxY(), interest.maxZ()));
        double length = OUTLINE * interest.diagonal();
        settings.enabledSensors().values().forEach(sensor -> {
            if (Outlined.outline(sensor).orElse(null) instanceof Outline.Frustum frustum) {
                corners.addAll(frustum.corners(sensor.position(), length));
            }
        });
        settings.alert().protect().ifPresent(zone -> {
            Position reach = new Position(zone.radius(), zone.radius(), zone.radius());
            corners.add(zone.centre().plus(reach));
            corners.add(zone.centre().minus(reach));
        });
        protection.areas().forEach(area -> area.outline().forEach(corner -> {
            corners.add(new Position(corner.x(), corner.y(), area.bottom()));
            corners.add(new Position(corner.x(), corner.y(), area.top()));
        }));
        return AABB.around(corners);
    }

    /** The settings of the site. */
    public WorldSettings site() {
        return settings.world();
    }

    /** The protected zones, placed on the site. */
    public Protection protection() {
        return protection;
    }

    /** The colours of the kinds of sensors. */
    public KindColours colours() {
        return colours;
    }

    /**
     * The cut that removes the upper part of the site, so that the sensors and drones at the given time are visible
     * from above; empty unless most of them are under a roof. The time is in seconds since the start of the run.
     */
    public Optional<Cut> openRoof(double time) {
        List<Drone> drones = stage.dronesAt(time);
        long roofed = settings.enabledSensors().values().stream()
                        .filter(sensor -> isUnderRoof(sensor.position()))
                        .count()
                + drones.stream().filter(drone -> isUnderRoof(drone.origin())).count();
        int all = settings.enabledSensors().size() + drones.size();
        return 2 * roofed > all ? Optional.of(Cut.above(interest().maxZ() - 2.5)) : Optional.empty();
    }

    private boolean isUnderRoof(Position point) {
        Position sky = new Position(
                point.x(), point.y(), Math.max(point.z(), world.bounds().maxZ()) + 1.0);
        return !new Visibility(world).isFree(point, sky);
    }

    /**
     * Paints the site alone.
     *
     * @param width columns of the picture
     * @param height rows of the picture
     * @param cut the part to be cut away
     * @param abandoned queried repeatedly: once it is true, the result is no longer needed
     */
    public Backdrop backdrop(
            Orbit orbit, int width, int height, Optional<Cut> cut, Fineness fineness, BooleanSupplier abandoned) {
        CameraObject camera = orbit.camera(fineness.raysIn(width), fineness.raysIn(height));
        Canvas canvas = new Canvas(camera.width(), camera.height());
        painter.paint(camera, cut.orElse(null), fineness.shadows, canvas, abandoned);
        if (fineness.pixels == 1 && !abandoned.getAsBoolean()) {
            painter.outline(canvas, camera.focalLength());
        }
        return new Backdrop(orbit, width, height, cut, fineness, camera, canvas);
    }

    /** Draws the state at one time over a backdrop, which remains unchanged. */
    public BufferedImage draw(Backdrop backdrop, SiteState state, SiteStyle style) {
        Cut cut = backdrop.cut().orElse(null);
        CameraObject camera = backdrop.camera();
        double pixel = style.scale() * camera.height() / backdrop.height();
        Backdrop ground = style.skin()
                .map(skin -> skinLayer.over(backdrop, skin, style.scale()))
                .orElse(backdrop);
        Canvas canvas = state.rays()
                .map(rays -> rayLayer.over(ground, rays, style.filter(), pixel))
                .orElse(ground.canvas())
                .copy();
        painter.paint(camera, cut, state.drones().stream().map(DroneMark::drone).toList(), canvas);
        LinePainter lines = new LinePainter(camera, cut, canvas);
        StateLines stateLines = new StateLines(lines, pixel);
        WatchedFlights watched = new WatchedFlights(style.flights() ? state.stretches() : List.of());
        if (style.outlines()) {
            stateLines.outlines(state, colours, OUTLINE * interest().diagonal());
            stateLines.zones(protection);
        }
        if (style.flights()) {
            for (DroneMark drone : state.drones()) {
                stateLines.plumbLine(drone, world);
                if (style.lines().isEmpty() && !watched.has(drone.drone().id())) {
                    stateLines.flight(drone);
                }
            }
            watched.draw(stateLines, interest().diagonal());
            stateLines.lines(style.lines());
        }
        BufferedImage image = picture(backdrop, canvas);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        Orbit orbit = backdrop.orbit();
        if (isFlat(orbit) && orbit.elevation() > STEEP) {
            site().origin()
                    .ifPresent(origin ->
                            new Graticule(origin, orbit, image.getWidth(), image.getHeight(), style.scale()).draw(g));
        }
        Furniture furniture = new Furniture(g, image.getWidth(), image.getHeight(), style.scale());
        furniture.legend(
                state,
                colours,
                view(backdrop.orbit()),
                settings.alert().isProtecting(),
                style.lines().isEmpty() ? watched.legend() : style.lines().legend());
        furniture.scaleBar(backdrop.orbit().metresPerPixel(backdrop.height()), isFlat(backdrop.orbit()));
        furniture.northArrow(backdrop.orbit());
        furniture.credits(stage.credits());
        state.rays().ifPresent(rays -> furniture.levels(rays, style.filter(), state.time()));
        drawSymbols(
                new Symbols(g, camera, lines, image.getHeight() / (double) camera.height(), style.scale()),
                state,
                style,
                furniture.occupied(),
                watched);
        g.dispose();
        return image;
    }

    private static boolean isFlat(Orbit orbit) {
        return orbit.fov() < Math.toRadians(5.0);
    }

    private static String view(Orbit orbit) {
        if (!isFlat(orbit)) {
            return "in perspective";
        }
        return orbit.elevation() > STEEP ? "from above" : "from the side";
    }

    private static BufferedImage picture(Backdrop backdrop, Canvas canvas) {
        if (canvas.width >= backdrop.width()) {
            return canvas.toImage(canvas.width / backdrop.width());
        }
        BufferedImage image = new BufferedImage(backdrop.width(), backdrop.height(), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        g.drawImage(canvas.toImage(1), 0, 0, backdrop.width(), backdrop.height(), null);
        g.dispose();
        return image;
    }

    private void drawSymbols(
            Symbols symbols, SiteState state, SiteStyle style, List<Rectangle> furniture, WatchedFlights watched) {
        symbols.keepOff(furniture);
        for (SensorMark sensor : state.sensors()) {
            boolean selected = state.selected().filter(sensor.id()::equals).isPresent();
            symbols.sensor(sensor, colours.of(sensor.kind()), selected);
        }
        for (DroneMark drone : state.drones()) {
            symbols.drone(
                    drone, state.selected().filter(drone.drone().id()::equals).isPresent());
        }
        watched.write(symbols);
        if (style.flights()) {
            style.lines().write(symbols);
        }
        if (style.labels()) {
            symbols.writeNames();
        }
    }
}
