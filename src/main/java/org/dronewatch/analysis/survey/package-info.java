/** A summary of a detection field: coverage by height and condition, its gaps, and the evidence for each of them. */
package org.dronewatch.analysis.survey;
