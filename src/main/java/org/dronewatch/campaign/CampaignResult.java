package org.dronewatch.campaign;

import java.util.Optional;
import org.dronewatch.campaign.outcome.CampaignSummary;

/**
 * The results of a campaign so far.
 *
 * @param summary summary of its variants and of their comparison
 * @param stopping whether all cases were run, and what decided how many there are
 * @param sensitivity which settings matter; empty if the campaign does not ask for it, or not all cases were run
 */
public record CampaignResult(CampaignSummary summary, Stopping stopping, Optional<Sensitivity> sensitivity) {}
