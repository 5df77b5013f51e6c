package org.dronewatch.app;

import java.io.PrintWriter;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.dronewatch.app.console.Notes;
import org.dronewatch.app.option.JsonOption;
import org.dronewatch.app.option.SceneChoice;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.world.Places;
import org.dronewatch.world.SurfaceColumn;
import org.dronewatch.world.World;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** Prints the heights of a site at a place, and what is there. */
@Command(
        name = "height",
        mixinStandardHelpOptions = true,
        description =
                "Prints the heights of the ground and of the surface at a place on a scene's site, and the objects"
                        + " there.",
        footer = {
            "",
            "Examples:",
            "  dronewatch height site.yaml --at 43.7314,7.4202",
            "  dronewatch height site.yaml --at '{east: 120 m, north: -40 m, above: 10 m}'"
        })
final class HeightCommand implements Callable<Integer> {
    private static final String AT = "--at";

    @Mixin
    private SceneChoice choice;

    @Option(
            names = AT,
            required = true,
            paramLabel = "PLACE",
            description =
                    "Latitude and longitude in degrees, such as 43.7314,7.4202, or a place written as in a scene file,"
                            + " such as '{east: 120 m, north: -40 m}'.")
    private String at;

    @Mixin
    private JsonOption json = new JsonOption();

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        SceneRunner runner = choice.runner(choice.create());
        runner.notes(Notes.of(spec));
        SceneSettings settings = SceneChoice.settingsOfRun(runner, 0);
        // Anything that is not a place is refused before the site is loaded.
        Position place = runner.place(AT, at, settings);
        World world = runner.world(settings);
        SurfaceColumn column = SurfaceColumn.at(world, place.x(), place.y());
        if (column.highest().isEmpty()) {
            throw new InputException(String.format(
                    Locale.ROOT,
                    "%s %s: no surface at x %.1f m, y %.1f m: the site has a hole or ends there",
                    AT,
                    PlainText.value(at),
                    place.x(),
                    place.y()));
        }
        Optional<Geodesy> geodesy = settings.world().origin().map(Geodesy::new);
        boolean aboveTheSea = new Places(settings.world(), world::newGround).heightsAreKnown();
        json.print(
                () -> toJson(place, column, geodesy, aboveTheSea),
                out -> print(place, column, geodesy, aboveTheSea, out));
        return 0;
    }

    private static ObjectNode toJson(
            Position place, SurfaceColumn column, Optional<Geodesy> geodesy, boolean aboveTheSea) {
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        geodesy.map(earth -> earth.onEarth(place)).ifPresent(point -> {
            root.put("latitude_deg", Numbers.rounded(point.latitude()));
            root.put("longitude_deg", Numbers.rounded(point.longitude()));
        });
        root.put("x", Numbers.rounded(place.x()));
        root.put("y", Numbers.rounded(place.y()));
        root.put("z", Numbers.rounded(place.z()));
        Optional<SurfaceColumn.Surface> ground = column.ground();
        ArrayNode surfaces = root.putArray("surfaces");
        for (SurfaceColumn.Surface surface : column.surfaces()) {
            ObjectNode one = surfaces.addObject();
            one.put("z", Numbers.rounded(surface.z()));
            geodesy.filter(earth -> aboveTheSea)
                    .ifPresent(earth -> one.put("above_sea_m", Numbers.rounded(aboveSea(earth, place, surface))));
            ground.ifPresent(low -> one.put("above_ground_m", Numbers.rounded(surface.z() - low.z())));
            one.put("ground", ground.filter(surface::equals).isPresent());
            one.put("role", surface.what().model().role().name().toLowerCase(Locale.ROOT));
            one.put("file", surface.what().model().file());
            one.put("material", surface.what().material());
            one.put("faces_up", surface.facesUp());
        }
        return root;
    }

    private static double aboveSea(Geodesy earth, Position place, SurfaceColumn.Surface surface) {
        return earth.onEarth(new Position(place.x(), place.y(), surface.z())).height();
    }

    private static void print(
            Position place, SurfaceColumn column, Optional<Geodesy> geodesy, boolean aboveTheSea, PrintWriter out) {
        double top = column.highest().orElseThrow().z();
        Optional<SurfaceColumn.Surface> ground = column.ground();
        geodesy.ifPresent(earth -> {
            GeoPoint point = earth.onEarth(place);
            out.printf(
                    Locale.ROOT, "place: latitude %.6f deg, longitude %.6f deg%n", point.latitude(), point.longitude());
        });
        out.printf(
                Locale.ROOT,
                "place: x %.2f m, y %.2f m, z %.2f m, %.2f m above the surface%n",
                plain(place.x()),
                plain(place.y()),
                plain(place.z()),
                plain(place.z() - top));
        for (SurfaceColumn.Surface surface : column.surfaces()) {
            boolean isGround = ground.filter(surface::equals).isPresent();
            String name = isGround ? "ground" : surface.z() == top ? "surface" : "below";
            String sea = geodesy.filter(earth -> aboveTheSea)
                    .map(earth ->
                            String.format(Locale.ROOT, ", %.2f m above sea level", aboveSea(earth, place, surface)))
                    .orElse("");
            String over = ground.filter(low -> surface.z() > low.z())
                    .map(low -> String.format(Locale.ROOT, ", %.2f m above the ground", surface.z() - low.z()))
                    .orElse("");
            out.printf(
                    Locale.ROOT,
                    "%s: z %.2f m%s%s: %s%n",
                    isGround && surface.z() == top ? "ground and surface" : name,
                    surface.z(),
                    sea,
                    over,
                    what(surface));
        }
    }

    /** A height rounded to centimetres, and never -0. */
    private static double plain(double metres) {
        return Math.round(100.0 * metres) / 100.0;
    }

    private static String what(SurfaceColumn.Surface surface) {
        String file = surface.what().model().file();
        String role = surface.what().model().role().name().toLowerCase(Locale.ROOT);
        String material = surface.what().material();
        return role
                + (file.isEmpty() ? "" : " of " + PlainText.value(file))
                + (material.isEmpty() ? "" : ", " + PlainText.value(material))
                + (surface.facesUp() ? "" : ", facing down");
    }
}
