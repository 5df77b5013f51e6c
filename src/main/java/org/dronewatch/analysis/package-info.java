/** What a layout can do before anything flies: coverage. */
package org.dronewatch.analysis;
