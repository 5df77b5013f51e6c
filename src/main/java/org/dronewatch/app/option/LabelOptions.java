package org.dronewatch.app.option;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronewatch.render.photo.ColourCamera;
import org.dronewatch.report.labels.LabelPlan;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Option;

/** The options of {@code run} for labelled pictures taken by cameras. */
public final class LabelOptions {
    private static final String LABELS = "--labels";

    @Option(
            names = LABELS,
            paramLabel = "CAMERA",
            description = "Writes the picture that this camera takes at each look (labels/CAMERA/000000.png and so on),"
                    + " and annotates the drones in it (coco.json); may be repeated.")
    private List<String> cameras = new ArrayList<>();

    @Option(
            names = "--samples",
            paramLabel = "N",
            description = "With --labels, each pixel of a picture is the mean of N x N rays, 1 to "
                    + ColourCamera.MOST_SAMPLES + "; " + ColourCamera.SAMPLES + " by default.")
    private Integer samples;

    /** The plan for the labelled pictures; empty if none are requested. */
    public Optional<LabelPlan> plan(SceneRunner runner) {
        if (cameras.isEmpty()) {
            if (samples != null) {
                throw new InputException("--samples " + samples + ": has no effect without --labels");
            }
            return Optional.empty();
        }
        int each = ColourOptions.checked("--samples", samples);
        return Optional.of(LabelPlan.of(LABELS, cameras, each, runner.settingsOfRuns()));
    }
}
