package org.dronewatch.report.route;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.SiteRoutes;
import org.dronewatch.route.proof.ProvenChance;
import org.dronewatch.sensor.Mounted;

/** The table of the weakest routes, one for each sector, and the weakest of all in words. */
public final class RouteTable {
    private static final String ROW = "%-11s  %8s  %16s  %11s  %8s  %8s  %10s";
    private static final String PROOF = "%-11s  %16s  %22s  %10s  %6s";
    private static final String CUED = "  %12s";
    private static final String IN_TIME = "  %10s  %13s";
    private static final String MODE = "  %10s";
    private static final String ALERT = "  %13s";
    private static final String STOPPED = "  %8s";

    private RouteTable() {}

    /** The lines of the table. */
    public static List<String> lines(RouteResults results, RouteInputs inputs) {
        RouteSurvey survey = results.survey();
        List<String> lines = new ArrayList<>();
        boolean isRequired = survey.response() > 0.0;
        lines.add("weakest routes of drone '" + inputs.drone() + "' to " + inputs.targetInWords()
                + ", by starting direction"
                + (isRequired
                        ? "; exposure counts while at least " + Numbers.text(survey.response())
                                + " s are left for the response:"
                        : ":"));
        lines.add(text(ROW, "from", "flight", "counted exposure", "lower bound", "search", "detected", "time left")
                + (ModeWords.areSlow(survey) ? text(MODE, "slow") : "")
                + (ModeWords.areGlides(survey) ? text(MODE, "motors off") : "")
                + (isRequired ? text(IN_TIME, "in time", "response") : "")
                + (survey.isAlertKnown() ? text(ALERT, "alert in time") : "")
                + (inputs.stopped().isEmpty() ? "" : text(STOPPED, "stopped"))
                + "  most exposed to");
        for (int sector = 0; sector < SiteRoutes.SECTORS; sector++) {
            Optional<SectorRoute> route = RouteWords.route(sector, survey);
            String name = RouteWords.sector(sector);
            if (route.isPresent()) {
                lines.add(row(name, route.get(), results, inputs));
            } else if (survey.isComplete()) {
                lines.add(name + ": no route");
            }
        }
        if (!results.proofs().isEmpty()) {
            lines.add("");
            lines.addAll(proofs(results, inputs));
        }
        lines.add("");
        lines.addAll(summary(results, inputs));
        return lines;
    }

    /** The weakest of all routes in words, and the limitations of these figures: a line for each sentence. */
    public static List<String> summary(RouteResults results, RouteInputs inputs) {
        RouteNotes notes = new RouteNotes(inputs);
        List<String> lines = new ArrayList<>();
        lines.add(new RouteWords(inputs).weakest(results));
        lines.addAll(notes.notes(results));
        notes.warnings(results.survey()).forEach(text -> lines.add("warning: " + text));
        return lines;
    }

    /**
     * What the search does that makes it misjudge the probability of a detection in time on one of the routes, as a
     * predicate: {@code assesses each cell only at its centre}; empty if the search does not misjudge the route.
     */
    public static Optional<String> misjudgement(SectorRoute route, RouteResults results, RouteInputs inputs) {
        return new RouteNotes(inputs).misjudgement(route, results.survey());
    }

    private static String row(String name, SectorRoute route, RouteResults results, RouteInputs inputs) {
        RouteSurvey survey = results.survey();
        double response = survey.response();
        String line = text(
                ROW,
                name,
                RouteNumbers.seconds(OptionalDouble.of(route.route().seconds())),
                RouteNumbers.exposure(route.route().exposure()),
                RouteNumbers.exposure(route.route().lower()),
                RouteNumbers.percent(route.searched().detection()),
                RouteNumbers.percent(route.detection()),
                RouteNumbers.seconds(route.left()));
        String slow =
                ModeWords.areSlow(survey) ? text(MODE, RouteNumbers.seconds(ModeWords.slowed(route, survey))) : "";
        String glide =
                ModeWords.areGlides(survey) ? text(MODE, RouteNumbers.seconds(ModeWords.gliding(route, survey))) : "";
        String timely = response > 0.0
                ? text(
                        IN_TIME,
                        RouteNumbers.percent(route.inTime(response)),
                        RouteNumbers.margin(route.left(), response))
                : "";
        String alert = survey.isAlertKnown() ? text(ALERT, RouteNumbers.orDash(route.alertInTime())) : "";
        String stopped = inputs.stopped().isEmpty()
                ? ""
                : text(STOPPED, RouteNumbers.orDash(RouteResults.effectiveness(route, inputs)));
        return line
                + slow
                + glide
                + timely
                + alert
                + stopped
                + route.mostExposedTo()
                        .map(sensor -> "  " + sensor + " (" + RouteNumbers.percent(route.share(sensor)) + ")")
                        .orElse("  -");
    }

    private static List<String> proofs(RouteResults results, RouteInputs inputs) {
        List<String> lines = new ArrayList<>();
        boolean isCued = results.proofs().values().stream()
                .anyMatch(proof -> proof.cued().isPresent());
        boolean isTurning = inputs.settings().enabledSensors().values().stream()
                .anyMatch(sensor -> Mounted.positioner(sensor).isPresent());
        lines.add("flown with many seeds" + (isTurning ? ", positioners searching" : "")
                + (isCued ? ", and with cues:" : ":"));
        lines.add(text(PROOF, "from", "detected", "99 % interval", "predicted", "agrees")
                + (isCued ? text(CUED, "with cues") : ""));
        results.proofs()
                .forEach((sector, proof) -> lines.add(proof(sector, proof.detection())
                        + proof.cued()
                                .map(cued -> text(CUED, cued.count() + " of " + cued.of()))
                                .orElse("")));
        if (results.proofs().values().stream()
                .anyMatch(proof -> proof.alertInTime().isPresent())) {
            lines.add("");
            lines.add("alerts raised on these flights at least "
                    + Numbers.text(results.survey().response()) + " s before the drone arrives:");
            lines.add(text(PROOF, "from", "in time", "99 % interval", "predicted", "agrees"));
            results.proofs().forEach((sector, proof) -> proof.alertInTime()
                    .ifPresent(alert -> lines.add(proof(sector, alert))));
        }
        return lines;
    }

    private static String proof(int sector, ProvenChance proven) {
        return text(
                PROOF,
                RouteWords.sector(sector),
                proven.flown().count() + " of " + proven.flown().of(),
                RouteNumbers.percent(proven.interval().low()) + " to "
                        + RouteNumbers.percent(proven.interval().high()),
                RouteNumbers.percent(proven.predicted()),
                proven.agrees() ? "yes" : "no");
    }

    private static String text(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
