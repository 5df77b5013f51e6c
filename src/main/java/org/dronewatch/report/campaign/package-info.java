/** The files of a campaign: its plan, its cases as they are run, and their results. */
package org.dronewatch.report.campaign;
