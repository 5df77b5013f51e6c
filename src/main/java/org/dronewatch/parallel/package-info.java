/**
 * Work that is spread over threads, with results that do not depend on how many there are; and whether the processor's
 * vector instructions can be used.
 */
package org.dronewatch.parallel;
