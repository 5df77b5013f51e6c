package org.dronewatch.app;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronewatch.app.console.ExitCode;
import org.dronewatch.app.console.TaskProgress;
import org.dronewatch.app.option.JsonOption;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CaseRun;
import org.dronewatch.campaign.CaseScene;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.report.campaign.CasePictures;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.viewer.Viewer;
import picocli.CommandLine.Option;

/** The options that run a single case of a campaign again. */
final class CaseOptions {
    @Option(
            names = "--case",
            paramLabel = "K",
            description = "Runs only the case with this index, counted from 0, and prints its values and results.")
    private Integer number;

    @Option(
            names = "--view",
            description = "With --case: also opens a window that shows the case with the first variant, or with the one"
                    + " given by --variant.")
    private boolean view;

    @Option(
            names = "--picture",
            paramLabel = "FILE.png",
            description = "With --case: also writes a picture from above, of the first variant or of the one given by"
                    + " --variant; the colour of the flight path shows which sensors detect the drone.")
    private String picture;

    @Option(names = "--variant", paramLabel = "NAME", description = "With --case: only this variant.")
    private String variant;

    /**
     * Whether a single case is asked for.
     *
     * @throws InputException when none is asked for although another option needs one
     */
    boolean isAsked() {
        if (number == null && (view || picture != null || variant != null)) {
            String option = view
                    ? "--view"
                    : picture != null
                            ? "--picture " + PlainText.value(picture)
                            : "--variant " + PlainText.value(variant);
            throw new InputException(option + ": needs --case K, the case to be run");
        }
        if (picture != null && !picture.toLowerCase(Locale.ROOT).endsWith(".png")) {
            throw new InputException("--picture " + PlainText.value(picture) + ": must end in .png");
        }
        return number != null;
    }

    /** Runs the case; returns the exit code. */
    int run(CampaignPlan plan, int threads, JsonOption json, TaskProgress shown) {
        if (number < 0 || number >= plan.size()) {
            throw new InputException("--case " + number + ": must be 0 to " + (plan.size() - 1));
        }
        List<String> variants = plan.variants();
        if (variant != null && !variants.contains(variant)) {
            throw new InputException("--variant " + PlainText.value(variant) + ": no such variant; the campaign has "
                    + String.join(", ", variants));
        }
        SceneWindow window = new SceneWindow(threads, shown.err(), shown.notes());
        if (view && !window.canOpen()) {
            return ExitCode.NO_DISPLAY;
        }
        WholeFile target = picture == null ? null : new WholeFile("--picture", picture);
        List<CaseResult> results = (variant == null ? variants : List.of(variant))
                .stream().map(one -> CaseRun.of(plan, number, one)).toList();
        json.print(() -> CaseJson.of(plan, number, results), out -> {
            CampaignLines.printValues(plan, number, out);
            results.forEach(result -> CampaignLines.print(result, out));
        });
        String pictured = variant == null ? variants.get(0) : variant;
        if (variant == null && variants.size() > 1 && (view || picture != null)) {
            shown.notes().accept("showing " + pictured + "; --variant selects another");
        }
        if (picture != null) {
            target.write(stream -> new CasePictures(plan).write(number, pictured, stream));
            shown.notes().accept("written to " + PlainText.value(picture));
        }
        if (view) {
            CaseScene one = plan.scene(number, pictured);
            window.show(new Viewer.Subject(one.scene(), one.runner(), Optional.empty()), viewer -> {});
        }
        return 0;
    }
}
