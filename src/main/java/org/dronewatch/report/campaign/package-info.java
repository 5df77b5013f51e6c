/** The files of a campaign: its plan, its cases as they are run, and what came of them. */
package org.dronewatch.report.campaign;
