package org.dronewatch.report.route;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.dronewatch.report.Charts;
import org.dronewatch.report.JsonFile;
import org.dronewatch.report.OutputDirectory;
import org.dronewatch.report.coverage.MapSheet;
import org.dronewatch.report.map.RouteMap;
import org.dronewatch.report.provenance.Provenance;
import org.dronewatch.report.provenance.ProvenanceFile;
import org.dronewatch.run.ModelCache;
import org.dronewatch.run.Stage;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/** The directory into which {@code route} writes; its files appear together, or none of them. */
public final class RouteDirectory implements AutoCloseable {
    private static final String NUMBERS = "route.json";

    /** All other files that a search may write: those of an earlier one are removed unless they are replaced. */
    private static final Pattern FILES = Pattern.compile(
            "route-(north|south)?-?(east|west)?\\.yaml|(routes|profile|time-to-go|view)\\.png|routes\\.(geojson|kml)|report\\.html");

    /** Files of other commands, whose {@code report.html} would be replaced. */
    private static final List<String> OTHERS = List.of("result.json", "coverage.json", "campaign.json");

    private final Path target;
    private final OutputDirectory directory;

    /**
     * Makes sure that the directory can be written, before the work begins.
     *
     * @throws InputException when it cannot
     */
    public RouteDirectory(Path target) {
        for (String other : OTHERS) {
            if (Files.isRegularFile(target.resolve(other))) {
                throw new InputException("output directory " + PlainText.value(target) + " holds " + other
                        + " of another command, whose report.html would be replaced: name another directory");
            }
        }
        this.target = target;
        this.directory = new OutputDirectory(target);
    }

    /**
     * Writes all files, on the {@link org.dronewatch.parallel.Workers} of the calling thread.
     *
     * @param stage the site
     * @param models of the scene
     * @param provenance origin of the results
     * @param threads number of worker threads
     * @param notes receives a line on what could not be written
     * @throws InputException when writing fails
     */
    public void write(
            RouteResults results,
            RouteInputs inputs,
            RouteScenes scenes,
            Stage stage,
            ModelCache models,
            Provenance provenance,
            int threads,
            Consumer<String> notes) {
        directory.write(() -> {
            JsonFile.write(directory.file(NUMBERS), RouteFile.toJson(results, inputs));
            JsonFile.write(directory.file(ProvenanceFile.NAME), ProvenanceFile.of(provenance, inputs.scene(), threads));
            if (inputs.origin().isPresent()) {
                RouteMap map = new RouteMap(inputs.scene(), inputs.origin().get(), RoutePieces.of(results.survey()));
                map.writeGeoJson(directory.file("routes.geojson"));
                map.writeKml(directory.file("routes.kml"));
            } else {
                notes.accept("the scene has no world.origin: no GeoJSON or KML files are written");
            }
            scenes.write(results.survey(), target, directory).ifPresent(notes);
            int[] ground = MapSheet.ground(stage.world(), inputs.grid());
            MapSheet plan = new RoutePictures(stage, inputs).plan(results.survey(), ground);
            MapSheet times = new TimeToGoPicture(stage, inputs, results.times()).sheet(ground);
            Optional<BufferedImage> view = RouteView.of(results.survey(), inputs, scenes, models);
            write(plan, "routes.png");
            write(times, "time-to-go.png");
            Optional<BufferedImage> profile =
                    results.survey().weakest().map(route -> Charts.picture(RouteProfilePicture.of(route, inputs)));
            write(view, "view.png");
            write(profile, "profile.png");
            try (OutputStream page = Files.newOutputStream(directory.file("report.html"))) {
                new RouteReport(results, inputs, stage)
                        .write(
                                page,
                                List.of(plan, times),
                                view,
                                profile,
                                provenance.inWords(inputs.settings().run().seed(), threads));
            }
            directory.publish(directory.former(NUMBERS, FILES));
        });
    }

    private void write(MapSheet sheet, String name) throws IOException {
        try (OutputStream png = Files.newOutputStream(directory.file(name))) {
            sheet.writePng(png);
        }
    }

    private void write(Optional<BufferedImage> picture, String name) throws IOException {
        if (picture.isPresent()) {
            try (OutputStream png = Files.newOutputStream(directory.file(name));
                    ImageOutputStream stream = new MemoryCacheImageOutputStream(png)) {
                ImageIO.write(picture.get(), "png", stream);
            }
        }
    }

    /** Removes what was not written completely. */
    @Override
    public void close() {
        directory.close();
    }
}
