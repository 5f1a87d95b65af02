using System;

namespace Rabit.Uav.MissionControl;

/// <summary>A progress file that cannot be read; the message names it and says why.</summary>
public sealed class MissionProgressException : Exception
{
    internal MissionProgressException(string name, string fault, Exception? inner = null)
        : base($"Progress file '{name}': {fault}.", inner)
    {
    }
}
