package org.dronewatch.campaign.sensitivity;

/**
 * How much of the variance of a result is due to one factor, with 95 % bootstrap intervals. Estimates may lie slightly
 * below 0 or above 1.
 *
 * @param first the fraction of the variance that the factor explains alone
 * @param low lower bound of the interval of {@code first}
 * @param high upper bound of the interval of {@code first}
 * @param total the fraction that the factor explains alone and together with others, that is, the fraction that would
 *     remain if all others were known
 * @param totalLow lower bound of the interval of {@code total}
 * @param totalHigh upper bound of the interval of {@code total}
 */
public record SobolIndex(double first, double low, double high, double total, double totalLow, double totalHigh) {}
