package org.dronewatch.campaign;

import java.util.Optional;
import org.dronewatch.campaign.outcome.CampaignQuantity;
import org.dronewatch.campaign.outcome.Outcome;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.setting.InputException;

/** Checks that what a campaign asks for can be known in some of its cases. */
final class AskedOutcomes {
    private static final String RESPONSE = "alert.response";

    private final CampaignPlan plan;

    AskedOutcomes(CampaignPlan plan) {
        this.plan = plan;
    }

    /**
     * Checks what decides the number of cases, and what is to be explained.
     *
     * @throws InputException when it is known in no case
     */
    void check() {
        plan.settings()
                .until()
                .filter(until -> until.of() == Outcome.IN_TIME)
                .ifPresent(until -> require("until.of: in_time", plan.observed(), true));
        plan.sensitivity().ifPresent(cases -> {
            String variant = cases.variants().get(0);
            CampaignQuantity output = cases.settings().output();
            if (output == CampaignQuantity.WARNING_S || output == CampaignQuantity.IN_TIME) {
                String name = output == CampaignQuantity.IN_TIME ? "in_time" : "warning_s";
                require("sensitivity.output: " + name, variant, output == CampaignQuantity.IN_TIME);
            }
        });
    }

    private void require(String asked, String variant, boolean needsResponse) {
        AlertSettings alert = plan.shared(variant).alert();
        Optional<String> missing = Optional.empty();
        if (!alert.isProtecting()) {
            missing = Optional.of("protects nothing (alert.protect)");
        } else if (needsResponse && alert.response() == 0.0 && !plan.paths().contains(RESPONSE)) {
            missing = Optional.of("states no response time (" + RESPONSE + ")");
        }
        if (missing.isPresent()) {
            throw new InputException(asked + " is not known in any of the cases, because the scene "
                    + plan.variant(variant).described().name() + " " + missing.get());
        }
    }
}
