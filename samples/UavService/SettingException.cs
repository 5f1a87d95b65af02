using System;
using System.Collections.Generic;

namespace UavService;

/// <summary>Settings are wrong.</summary>
/// <param name="faults">A line for each.</param>
internal sealed class SettingException(IReadOnlyList<string> faults) : Exception(string.Join("; ", faults))
{
    public IReadOnlyList<string> Faults { get; } = faults;
}
