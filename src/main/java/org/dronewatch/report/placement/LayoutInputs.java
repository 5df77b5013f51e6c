package org.dronewatch.report.placement;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.placement.plan.PlacePlan;

/**
 * The files from which a layout is found.
 *
 * @param files their paths
 */
record LayoutInputs(List<Path> files) {
    /** Copies the list. */
    LayoutInputs {
        files = List.copyOf(files);
    }

    /** The placement file and the files of its plan. */
    static LayoutInputs of(Path placement, PlacePlan plan) {
        List<Path> files = new ArrayList<>(List.of(placement));
        plan.conditionsFile().ifPresent(files::add);
        plan.scene().files().stream()
                .limit(1)
                .map(scene -> plan.scene().directory().resolve(scene.file()))
                .forEach(files::add);
        return new LayoutInputs(files);
    }

    /** Whether a file, which need not exist, is one of them. */
    boolean has(Path file) {
        return Files.exists(file) && files.stream().anyMatch(input -> isSame(input, file));
    }

    private static boolean isSame(Path input, Path file) {
        try {
            return Files.isSameFile(input, file);
        } catch (IOException e) {
            // An input that is gone cannot be replaced.
            return false;
        }
    }
}
