package org.dronewatch.campaign.sensitivity;

/**
 * How much of the variance of a result is due to one factor, with 95 % bootstrap intervals. Estimates may lie slightly
 * below 0 or above 1.
 *
 * @param first the fraction of the variance that the factor explains alone
 * @param low lower bound of it
 * @param high upper bound of it
 * @param total what it explains alone and together with others: what would remain if all others were known
 * @param totalLow lower bound of it
 * @param totalHigh upper bound of it
 */
public record SobolIndex(double first, double low, double high, double total, double totalLow, double totalHigh) {}
