/**
 * Distribution of work over threads, with results that do not depend on their number; and the check for vector
 * instructions.
 */
package org.dronewatch.parallel;
