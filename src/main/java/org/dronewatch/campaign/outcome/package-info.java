/** The outcomes of a campaign's cases, the summary of each variant, and the rule for when there are enough cases. */
package org.dronewatch.campaign.outcome;
