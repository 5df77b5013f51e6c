/** How much of a result's variation is due to each of the factors that it depends on; independent of campaigns. */
package org.dronewatch.campaign.sensitivity;
