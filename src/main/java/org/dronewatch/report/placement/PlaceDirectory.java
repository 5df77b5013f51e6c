package org.dronewatch.report.placement;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import org.dronewatch.placement.site.Layout;
import org.dronewatch.placement.site.PlacePlan;
import org.dronewatch.placement.site.RoutePlacement;
import org.dronewatch.placement.site.SiteCandidate;
import org.dronewatch.placement.site.SitePlacement;
import org.dronewatch.report.JsonFile;
import org.dronewatch.report.OutputDirectory;
import org.dronewatch.report.provenance.Provenance;
import org.dronewatch.report.provenance.ProvenanceFile;
import org.dronewatch.report.provenance.ResultKind;
import org.dronewatch.setting.InputException;
import tools.jackson.databind.node.ObjectNode;

/** The directory into which {@code place} writes; its files appear together, or none of them. */
public final class PlaceDirectory implements AutoCloseable {
    private static final String NUMBERS = ResultKind.PLACE.sign();
    private static final String SCENE = "layout.yaml";

    private final Path target;
    private final OutputDirectory directory;

    /**
     * Makes sure that the directory can be written, before the work begins.
     *
     * @throws InputException when it cannot, or holds the results of another command
     */
    public PlaceDirectory(Path target) {
        ResultKind.PLACE.checkAlone(target);
        this.target = target;
        this.directory = new OutputDirectory(target);
    }

    /**
     * Writes all files.
     *
     * @param provenance origin of the results
     * @param threads number of worker threads
     * @param notes receives a line on what could not be written
     * @throws InputException when writing fails
     */
    public void write(PlaceResults results, Provenance provenance, int threads, Consumer<String> notes) {
        SitePlacement best = results.best();
        write(best.plan(), best.chosen(), PlaceFile.toJson(results), provenance, threads, notes);
    }

    /** The same for the layout past which the weakest route is most exposed. */
    public void write(RoutePlacement placement, Provenance provenance, int threads, Consumer<String> notes) {
        write(placement.plan(), placement.chosen(), RoutePlaceFile.toJson(placement), provenance, threads, notes);
    }

    private void write(
            PlacePlan plan,
            List<SiteCandidate> chosen,
            ObjectNode numbers,
            Provenance provenance,
            int threads,
            Consumer<String> notes) {
        directory.write(() -> {
            JsonFile.write(directory.file(NUMBERS), numbers);
            JsonFile.write(
                    directory.file(ProvenanceFile.NAME),
                    ProvenanceFile.of(provenance, plan.scene().name(), threads));
            boolean isWritten = false;
            try {
                String text = plan.runner().text(Layout.of(plan, chosen), target.resolve(SCENE));
                Files.write(directory.file(SCENE), text.getBytes(StandardCharsets.UTF_8));
                isWritten = true;
            } catch (InputException e) {
                notes.accept("the layout is not written as a scene: " + e.getMessage());
            }
            // The scene of an earlier layout must not remain beside these results.
            directory.publish(isWritten || !Files.isRegularFile(target.resolve(NUMBERS)) ? List.of() : List.of(SCENE));
        });
    }

    /** Removes what was not written completely. */
    @Override
    public void close() {
        directory.close();
    }
}
