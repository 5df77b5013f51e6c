package org.dronewatch.report.route;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import org.dronewatch.report.JsonFile;
import org.dronewatch.report.OutputDirectory;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/** The directory into which {@code route} writes; its files appear together, or none of them. */
public final class RouteDirectory implements AutoCloseable {
    private static final String NUMBERS = "route.json";

    /** All other files that a search may write: those of an earlier one are removed unless they are replaced. */
    private static final Pattern FILES = Pattern.compile(
            "route-(north|south)?-?(east|west)?\\.yaml|(routes|profile)\\.png|routes\\.(geojson|kml)|report\\.html");

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
     * Writes all files.
     *
     * @param notes receives a line on what could not be written
     * @throws InputException when writing fails
     */
    public void write(RouteSurvey survey, RouteInputs inputs, RouteScenes scenes, Consumer<String> notes) {
        directory.write(() -> {
            JsonFile.write(directory.file(NUMBERS), RouteFile.toJson(survey, inputs));
            scenes.write(survey, target, directory).ifPresent(notes);
            directory.publish(directory.former(NUMBERS, FILES));
        });
    }

    /** Removes what was not written completely. */
    @Override
    public void close() {
        directory.close();
    }
}
