package org.dronewatch.report.campaign;

import java.util.List;
import java.util.Locale;
import org.dronewatch.campaign.Sensitivity;
import org.dronewatch.campaign.outcome.CampaignQuantity;
import org.dronewatch.campaign.sensitivity.MorrisEffect;
import org.dronewatch.campaign.sensitivity.SobolIndex;
import org.dronewatch.report.html.Html;
import org.dronewatch.setting.Counted;

/** Which settings matter, as bars. */
final class SensitivityBars {
    private final Sensitivity sensitivity;
    private final String what;

    SensitivityBars(Sensitivity sensitivity) {
        this.sensitivity = sensitivity;
        this.what = sensitivity.settings().output().words() + " with " + sensitivity.variant();
    }

    /** The section. */
    String html() {
        List<Sensitivity.Influence> influences = CampaignWords.ordered(sensitivity);
        if (influences.isEmpty()) {
            return Html.plain(
                    "p", "What explains the " + what + ": " + CampaignWords.withoutInfluences(sensitivity) + ".");
        }
        String left = sensitivity.failed() > 0
                ? " "
                        + Counted.of(
                                sensitivity.failed(),
                                "further case failed; its group is left out.",
                                "further cases failed; their groups are left out.")
                : "";
        return influences.get(0).index().isPresent() ? sobol(influences, left) : morris(influences, left);
    }

    private String sobol(List<Sensitivity.Influence> influences, String left) {
        IntervalBars bars = new IntervalBars("what explains the " + what, ShareWords.PERCENT, "%");
        for (Sensitivity.Influence one : influences) {
            SobolIndex index = one.index().orElseThrow();
            String name = CampaignWords.name(one);
            add(bars, name + ", alone: ", index.first(), index.low(), index.high(), 0);
            add(bars, name + ", with interactions: ", index.total(), index.totalLow(), index.totalHigh(), 1);
        }
        return Html.plain(
                        "p",
                        "The bars show how much of the variance of the " + what + " each setting explains, with 95 %"
                                + " confidence intervals: alone, and together with the others. No layout and no setting"
                                + " can remove what is due to chance." + left)
                + bars.svg();
    }

    private static void add(IntervalBars bars, String words, double value, double low, double high, int colour) {
        double percent = ShareWords.PERCENT;
        String text = String.format(
                Locale.ROOT,
                "%s%.1f %% (%.1f to %.1f)",
                words,
                CampaignWords.percent(value),
                CampaignWords.percent(low),
                CampaignWords.percent(high));
        bars.add(text, percent * value, percent * low, percent * high, SeriesStyle.colour(colour));
    }

    private String morris(List<Sensitivity.Influence> influences, String left) {
        CampaignQuantity output = sensitivity.settings().output();
        double most = influences.stream()
                .mapToDouble(one -> one.effect().orElseThrow().magnitude())
                .max()
                .orElse(0.0);
        IntervalBars bars = new IntervalBars("effects on the " + what, IntervalBars.roundEnd(most), output.unit());
        for (Sensitivity.Influence one : influences) {
            MorrisEffect effect = one.effect().orElseThrow();
            String words = String.format(
                    Locale.ROOT,
                    "%s: %.3f %s (deviation %.3f)",
                    CampaignWords.name(one),
                    effect.magnitude(),
                    output.unit(),
                    effect.deviation());
            bars.add(words, effect.magnitude(), 0.0, 0.0, SeriesStyle.colour(0));
        }
        return Html.plain(
                        "p",
                        "The bars show the mean magnitude of the change of the " + what + " when a setting changes"
                                + " across its whole distribution. A large deviation means that the effect depends on"
                                + " other settings."
                                + left)
                + bars.svg();
    }
}
