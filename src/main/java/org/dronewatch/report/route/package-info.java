/** The weakest routes of a site as tables, sentences, files and pictures. */
package org.dronewatch.report.route;
