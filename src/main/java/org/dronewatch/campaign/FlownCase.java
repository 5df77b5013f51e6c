package org.dronewatch.campaign;

import org.dronewatch.parallel.Workers;
import org.dronewatch.run.Frame;
import org.dronewatch.run.Pointings;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.RunSession;
import org.dronewatch.run.Stage;

/**
 * One case of a campaign with one variant, flown again to be drawn.
 *
 * @param name name of the case, the same as that of its {@link CaseScene}
 * @param run result of the case
 * @param stage site and drones of the case
 * @param pointings the directions in which the positioners pointed
 */
public record FlownCase(String name, RunResult run, Stage stage, Pointings pointings) {
    /**
     * Flies a case on the calling thread.
     *
     * @throws org.dronewatch.setting.InputException when its values are not valid together
     * @throws java.util.concurrent.CancellationException when the thread is interrupted
     */
    public static FlownCase of(CampaignPlan plan, int number, String variant) {
        Pointings pointings = new Pointings();
        try (Workers alone = new Workers(1);
                RunSession session = new RunSession(
                        plan.settings(number, variant),
                        plan.seed(number),
                        plan.variant(variant).models())) {
            return alone.call(() -> {
                while (session.nextTime().isPresent()) {
                    Frame frame = session.advance();
                    pointings.add(frame);
                }
                return new FlownCase(plan.name(number, variant), session.result(), session.stage(), pointings);
            });
        }
    }
}
