/** What the cases of a campaign come to: their outcomes, the summary of each variant, and when there are enough. */
package org.dronewatch.campaign.outcome;
