/** Sites that have been prepared, kept in files in the user's cache directory. */
package org.dronewatch.run.store;
