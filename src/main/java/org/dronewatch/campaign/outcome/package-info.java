/** The outcomes of the cases of a campaign, the summary of each variant, and when there are enough. */
package org.dronewatch.campaign.outcome;
