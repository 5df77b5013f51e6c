package org.dronewatch.campaign;

/**
 * The results of a campaign so far.
 *
 * @param summary of its variants and of their comparison
 * @param stopping whether all cases were run, and what decided how many there are
 */
public record CampaignResult(CampaignSummary summary, Stopping stopping) {}
