/** The searches of the {@code place} and {@code route} commands, which may take long and can be stopped. */
package org.dronewatch.app.search;
