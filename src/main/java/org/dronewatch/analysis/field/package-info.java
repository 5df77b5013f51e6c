/** The detection field of a site: where its sensors detect a drone at several heights, why not elsewhere, and how early. */
package org.dronewatch.analysis.field;
