package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.placement.plan.LossSettings;
import org.dronewatch.placement.route.RoutePlacement;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.setting.Quantity;

/**
 * What the search promises about a layout against the weakest route, compared with what flights show: flights past the
 * layout, and past what remains of it after a loss.
 *
 * @param best the layout
 * @param layout the routes past it, as flown; empty if they were not
 * @param lost the routes past the layout without a sensor, as flown, by the name of that sensor
 */
record FlownPromise(RoutePlacement best, Optional<FlownLayout> layout, Map<String, FlownLayout> lost) {
    /**
     * A loss, and the route on which the drone is then least likely to be detected in time.
     *
     * @param sensor sensor that is lost
     * @param flown the routes past the others
     * @param route the weakest of them, as flown
     */
    record Loss(String sensor, FlownLayout flown, SectorRoute route) {
        double inTime() {
            return flown.inTime(route);
        }
    }

    /** The weakest route as flown, if the probability of a detection, as printed, is lower there than promised. */
    Optional<SectorRoute> broken() {
        return layout.flatMap(flown -> flown.weakest()
                .filter(route -> flown.inTime(route) < detection())
                .filter(route -> !FrontWords.percent(flown.inTime(route)).equals(promised())));
    }

    private double detection() {
        return RoutePlacement.detection(best.value());
    }

    private String promised() {
        return FrontWords.percent(detection());
    }

    /** What flights show, in a sentence, if it is less than the search promises; otherwise empty. */
    Optional<String> shortfall() {
        return broken().map(route -> "As flown, the layout detects the drone in time with a probability of only "
                + FrontWords.percent(layout.orElseThrow().inTime(route)) + " on the weakest route past it, "
                + FlownLayout.from(route) + "; the search estimates " + promised()
                + layout.orElseThrow().because(route, ",") + ".");
    }

    /** What remains without the sensors whose loss is worst, in sentences; empty if it is not known. */
    Optional<String> worstLoss() {
        Map<String, Double> without = best.withoutEach();
        return without.values().stream().min(Double::compare).map(least -> {
            List<String> worst = best.worstLosses();
            return lossOf(worst, without.size()) + ", the layout detects the drone with a probability of "
                    + FrontWords.percent(RoutePlacement.detection(least))
                    + " on the weakest route past it, as estimated by the search."
                    + flownLoss().orElse("");
        });
    }

    private static String either(List<String> names) {
        return names.size() == 1
                ? names.get(0)
                : String.join(", ", names.subList(0, names.size() - 1)) + " or " + names.get(names.size() - 1);
    }

    private static String lossOf(List<String> worst, int all) {
        if (worst.size() == 1) {
            return "Without " + worst.get(0) + (all == 1 ? "" : ", whose loss is worst");
        }
        return "If " + either(worst) + " is lost"
                + (worst.size() == all ? "" : " (equally severe losses, the worst of all)");
    }

    /** What flights show about the worst of the losses that were flown, in sentences; empty if none was flown. */
    private Optional<String> flownLoss() {
        List<Loss> all = losses();
        return all.stream().min(Comparator.comparingDouble(Loss::inTime)).map(least -> {
            String chance = "detected in time with a probability of " + FrontWords.percent(least.inTime())
                    + ", on the route " + FlownLayout.from(least.route())
                    + least.flown().because(least.route(), "; the estimate of the search differs") + ".";
            String sentence = all.size() == 1
                    ? " In flights past the layout without " + least.sensor() + ", the drone is " + chance
                    : " In flights past the layout without each of these sensors in turn, the worst case is the loss"
                            + " of " + either(alike(all, least)) + ": the drone is then " + chance;
            return needed().stream().anyMatch(fraction -> least.inTime() < fraction)
                    ? sentence + " This is less than the " + Quantity.NUMBER.inWords(needed().getAsDouble())
                            + " that conditions.anyoneLost.atLeast asks for."
                    : sentence;
        });
    }

    /** The sensors whose losses are, as printed, as bad as the worst. */
    private static List<String> alike(List<Loss> all, Loss worst) {
        return all.stream()
                .filter(one -> FrontWords.percent(one.inTime()).equals(FrontWords.percent(worst.inTime())))
                .map(Loss::sensor)
                .toList();
    }

    /** The losses that were flown. */
    List<Loss> losses() {
        List<Loss> all = new ArrayList<>();
        lost.forEach((sensor, flown) -> flown.weakest().ifPresent(route -> all.add(new Loss(sensor, flown, route))));
        return all;
    }

    /** The probability of a detection that must remain after a loss; empty if none is asked for. */
    private OptionalDouble needed() {
        return best.plan().settings().conditions().anyoneLost().stream()
                .mapToDouble(LossSettings::fraction)
                .findFirst();
    }
}
