/** Work that is spread over threads, with results that do not depend on how many there are. */
package org.dronewatch.parallel;
