package org.dronewatch.app.create;

import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronewatch.analysis.CoveredApproach;
import org.dronewatch.analysis.HighPoints;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.World;

/**
 * The text of a scene for a real place: its ground and buildings, a sensor of each kind, an intruder and a protected
 * zone, with comments that say what to change.
 *
 * @param name name of the scene
 * @param latitude latitude of the origin, degrees
 * @param longitude longitude of the origin, degrees
 * @param radius radius of the site, m
 * @param terrain names of the elevation files beside the scene
 * @param terrainCrs coordinate reference system of these files, if they do not state it
 * @param isSurface whether the elevations include roofs and treetops
 * @param buildings name of the map beside the scene
 * @param mapCrs coordinate reference system of the map, if it does not state it
 */
public record NewScene(
        String name,
        double latitude,
        double longitude,
        double radius,
        List<String> terrain,
        Optional<String> terrainCrs,
        boolean isSurface,
        Optional<String> buildings,
        Optional<String> mapCrs) {
    /** Masts stand within this distance of the origin along each axis, m, or an eighth of the radius. */
    private static final double MASTS_WITHIN = 250.0;

    private static final double MASTS_APART = 60.0;

    /** How far away the intruder starts, as a fraction of the radius; and the greatest distance, m. */
    private static final double START = 0.85;

    private static final double FARTHEST_START = 1500.0;
    private static final double HEIGHT = 30.0;
    private static final double SPEED = 15.0;
    private static final double MAST = 6.0;

    /** The text of a scene with the site alone. The site has to be read before sensors can be placed on it. */
    public String site() {
        StringBuilder text = new StringBuilder();
        line(
                text,
                "# %s, created by 'dronewatch new'. Everything here may be changed: 'dronewatch check' reports mistakes,",
                name);
        line(text, "# 'dronewatch view' shows the scene, and the page on all settings lists the other settings.");
        line(text, "world:");
        line(
                text,
                "  # The point x = y = 0. Heights are measured from the zero level of the elevations, usually sea"
                        + " level.");
        line(text, "  origin: {latitude: %s deg, longitude: %s deg, height: 0}", number(latitude), number(longitude));
        if (!terrain.isEmpty()) {
            line(text, "  terrain:");
            line(text, terrain.size() == 1 ? "    file: %s" : "    files: [%s]", names());
            terrainCrs.ifPresent(code -> line(text, "    crs: %s", code));
            line(text, "    radius: %s", Quantity.LENGTH.inWords(radius));
            line(text, "    accuracy: 1 m  # maximum vertical error that simplifying the terrain mesh may cause");
            line(
                    text,
                    isSurface
                            ? "    surface: dsm  # these heights include roofs and treetops; dtm is bare ground"
                            : "    surface: dtm  # bare ground; dsm if these heights include roofs and treetops");
        }
        buildings.ifPresent(file -> {
            line(text, "  buildings:");
            line(text, "    file: %s", quoted(file));
            mapCrs.ifPresent(code -> line(text, "    crs: %s", code));
            line(text, "    radius: %s", Quantity.LENGTH.inWords(radius));
            line(text, "    height: 9 m  # of buildings for which the map states neither height nor levels");
            if (!terrain.isEmpty() && !isCityModel(file)) {
                line(
                        text,
                        "    landCover: true  # colours and acoustic surfaces of water, roads, woods, ... on the ground");
            }
        });
        line(
                text,
                "  backgroundNoise: 45 dB  # A-weighted: 30 in quiet countryside, 40 in a suburb, 55 in a city by day");
        line(text, "");
        line(text, "run: {duration: 1 s}");
        return text.toString();
    }

    /** Whether a map is a city model, which states no land cover. */
    private static boolean isCityModel(String file) {
        return file.toLowerCase(Locale.ROOT).endsWith(".city.json");
    }

    private String names() {
        return terrain.stream().map(NewScene::quoted).collect(Collectors.joining(", "));
    }

    /** A name in YAML, in quotes if it might otherwise mean something else. */
    private static String quoted(String file) {
        return file.matches("[A-Za-z0-9_][A-Za-z0-9_.-]*") ? file : "'" + file.replace("'", "''") + "'";
    }

    /** The text of the whole scene, with sensors and a flight where the site suggests them. */
    public String whole(World world) {
        double within = Math.min(MASTS_WITHIN, 0.125 * radius);
        List<Position> masts = HighPoints.near(world, within, 2, MASTS_APART);
        if (masts.isEmpty()) {
            throw new InputException(nothingWithin(within, world.mesh().bounds()));
        }
        Position first = masts.get(0);
        Position second = masts.get(masts.size() - 1);
        Position watcher = first.plus(new Position(0, 0, MAST));
        double length = Math.min(START * radius, FARTHEST_START);
        Optional<CoveredApproach> covered = CoveredApproach.to(world, watcher, length, HEIGHT);
        Position start =
                covered.map(CoveredApproach::start).orElseGet(() -> new Position(0, length, first.z() + HEIGHT));
        Position towards = start.minus(watcher);
        String aim = String.format(
                Locale.ROOT,
                "{azimuth: %.0f deg, elevation: %.0f deg}",
                (whole(Math.toDegrees(Math.atan2(towards.x(), towards.y()))) + 360.0) % 360.0,
                whole(Math.toDegrees(Math.atan2(towards.z(), Math.hypot(towards.x(), towards.y())))));

        StringBuilder text = new StringBuilder(site().replaceFirst("(?s)run:.*", ""));
        line(text, "drones:");
        line(text, "  intruder:");
        line(text, "    model: packaged:quadrotor.obj");
        line(text, "    speed: %.0f m/s", SPEED);
        line(
                text,
                "    # Radar cross-section: 0.0524 m2 on average, log-normal (3GPP TR 38.901). large-uav has 0.26 m2; crossSection"
                        + " sets your own value.");
        line(text, "    radar: {droneClass: small-uav}");
        covered.ifPresentOrElse(
                way -> {
                    line(
                            text,
                            "    # Low over ground and roofs, from the direction in which the radar sees the least of"
                                    + " the path: %.0f %% of it is hidden.",
                            100.0 * way.hidden());
                    line(
                            text,
                            "    # Points are [east, north] of the origin, in metres; {latitude: ..., longitude: ...} is also"
                                    + " possible.");
                    line(
                            text,
                            "    flight: {kind: terrain-following, points: [[%.0f, %.0f], [0, 0]], height: %.0f m}",
                            whole(start.x()),
                            whole(start.y()),
                            HEIGHT);
                },
                () -> line(
                        text,
                        "    flight: {kind: approach, from: [%.0f, %.0f, %.0f], to: [0, 0, %.0f]}",
                        whole(start.x()),
                        whole(start.y()),
                        whole(start.z()),
                        whole(first.z() + HEIGHT)));
        line(text, "");
        line(
                text,
                "# One sensor of each kind, from the catalogue ('dronewatch list'), on the highest points near the origin.");
        line(text, "# 'above' is measured from the ground or the roof there.");
        line(text, "sensors:");
        line(text, "  radar: {use: blighter-a400-m10s, position: %s, aim: %s}", place(first, MAST), aim);
        line(text, "  radio: {use: droneshield-rfone, position: %s}", place(first, MAST - 1.0));
        line(text, "  # Turns to drones that the radar detects.");
        line(text, "  camera:");
        line(text, "    use: piranha-46-hr");
        line(text, "    position: %s", place(first, MAST - 2.0));
        line(text, "    aim: %s", aim);
        line(text, "    detection: {kind: target-task, task: recognition}");
        line(text, "    positioner: {use: viper, cues: [radar], hold: 6 s, zoom: {cued: 8 deg, tracked: 2.2 deg}}");
        line(text, "  thermal:");
        line(text, "    use: cooled-thermal-camera");
        line(text, "    position: %s", place(second, MAST));
        line(text, "    aim: %s", aim);
        line(text, "    positioner: {use: viper, cues: [radar], hold: 6 s}");
        line(text, "  microphone: {use: droneshield-v2, position: %s, rate: 2 Hz}", place(second, 2.0));
        line(text, "");
        line(text, "alert:");
        line(text, "  protect: {centre: %s, radius: 50 m}", middle(world));
        line(text, "  response: 30 s  # between alert and countermeasure");
        line(text, "");
        line(text, "run: {duration: %.0f s}", Math.ceil(Math.hypot(start.x(), start.y()) / SPEED) + 5.0);
        return text.toString();
    }

    /** States where there is something instead, and a place that can be given with {@code --at}. */
    private String nothingWithin(double within, AABB site) {
        GeoPoint middle = new Geodesy(Origin.at(Math.toRadians(latitude), Math.toRadians(longitude)))
                .onEarth(new Position(0.5 * (site.minX() + site.maxX()), 0.5 * (site.minY() + site.maxY()), 0.0));
        return String.format(
                Locale.ROOT,
                "there is neither ground nor a building for the sensors within %s of the origin, %s,%s: the files that"
                        + " were read extend from %.0f to %.0f m east and from %.0f to %.0f m north of it; to centre"
                        + " the site on them, give --at %.5f,%.5f",
                Quantity.LENGTH.inWords(within),
                number(latitude),
                number(longitude),
                whole(site.minX()),
                whole(site.maxX()),
                whole(site.minY()),
                whole(site.maxY()),
                middle.latitude(),
                middle.longitude());
    }

    /** A value rounded as it is written; never -0. */
    private static double whole(double value) {
        return Math.rint(value) + 0.0;
    }

    private static String place(Position at, double above) {
        return String.format(
                Locale.ROOT, "{east: %s m, north: %s m, above: %.0f m}", metres(at.x()), metres(at.y()), above);
    }

    private static String middle(World world) {
        return world.surfaceHeight(0.0, 0.0).isPresent() ? "{east: 0 m, north: 0 m, above: 2 m}" : "[0, 0, 2]";
    }

    private static String number(double value) {
        return BigDecimal.valueOf(value).stripTrailingZeros().toPlainString();
    }

    /** A length, rounded to the centimetre. */
    private static String metres(double value) {
        return number(Math.rint(100.0 * value) / 100.0);
    }

    private static void line(StringBuilder text, String pattern, Object... values) {
        text.append(String.format(Locale.ROOT, pattern, values)).append('\n');
    }

    /** The name for a scene in a directory: that of the directory if it is a valid name, otherwise {@code site}. */
    public static String nameIn(Path directory) {
        String last = String.valueOf(directory.getFileName());
        return last.matches("[A-Za-z0-9_-]{1,64}") ? last : "site";
    }
}
