using System;

namespace Rabit.Uav.MissionControl;

/// <summary>A progress file that cannot be read; the message names it and says why.</summary>
public sealed class MissionProgressException : Exception
{
    /// <param name="name">Name of the file.</param>
    /// <param name="fault">What is wrong with it; texts of the operating system end with a dot of their own.</param>
    /// <param name="inner">What was thrown where it was read; null for nothing.</param>
    internal MissionProgressException(string name, string fault, Exception? inner = null)
        : base($"Progress file '{name}': {fault.TrimEnd('.')}.", inner)
    {
    }
}
