/** What stands in the way of radio waves: edges of the site, and how much each takes. */
package org.dronewatch.sensor.radio;
