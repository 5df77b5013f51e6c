package org.dronewatch.app;

import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import org.dronewatch.campaign.CampaignPlan;
import org.dronewatch.campaign.CaseResult;
import org.dronewatch.campaign.CaseRun;
import org.dronewatch.campaign.CaseScene;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.viewer.Viewer;
import picocli.CommandLine.Option;

/** The options that run a single case of a campaign again. */
final class CaseOptions {
    @Option(
            names = "--case",
            paramLabel = "K",
            description = "Runs a single case, counted from 0, and prints its values and results; nothing is written.")
    private Integer number;

    @Option(
            names = "--view",
            description = "With --case: also opens a window that shows the case; the first variant, unless --variant"
                    + " names another.")
    private boolean view;

    @Option(names = "--variant", paramLabel = "NAME", description = "With --case: only this variant.")
    private String variant;

    /**
     * Whether a single case is asked for.
     *
     * @throws InputException when another option needs one
     */
    boolean isAsked() {
        if (number == null && (view || variant != null)) {
            throw new InputException((view ? "--view" : "--variant " + PlainText.value(variant))
                    + ": needs --case K, the case to be run");
        }
        return number != null;
    }

    /** Runs the case; returns the exit code. */
    int run(CampaignPlan plan, int threads, PrintWriter out, PrintWriter err) {
        if (number < 0 || number >= plan.size()) {
            throw new InputException("--case " + number + ": must be 0 to " + (plan.size() - 1));
        }
        List<String> variants = plan.variants();
        if (variant != null && !variants.contains(variant)) {
            throw new InputException("--variant " + PlainText.value(variant) + ": no such variant; the campaign has "
                    + String.join(", ", variants));
        }
        SceneWindow window = new SceneWindow(threads, err);
        if (view && !window.canOpen()) {
            return Main.NO_DISPLAY;
        }
        CampaignLines.printValues(plan, number, out);
        for (String one : variant == null ? variants : List.of(variant)) {
            CaseResult result = CaseRun.of(plan, number, one);
            CampaignLines.print(result, out);
        }
        if (view) {
            show(plan, window, err);
        }
        return 0;
    }

    private void show(CampaignPlan plan, SceneWindow window, PrintWriter err) {
        String shown = variant == null ? plan.variants().get(0) : variant;
        if (variant == null && plan.variants().size() > 1) {
            err.println("the window shows " + shown + "; --variant shows another");
        }
        CaseScene one = plan.scene(number, shown);
        window.show(new Viewer.Subject(one.scene(), one.runner(), Optional.empty()), viewer -> {});
    }
}
