/** How a setting of a campaign varies from case to case. */
package org.dronewatch.campaign.variation;
