/** The <em>Coverage</em> tab: its form, its computation in the background, and what it draws over the site. */
package org.dronewatch.viewer.coverage;
