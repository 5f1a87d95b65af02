using System;

namespace OrderBugSearch;

/// <summary>The pump house did not do what it is for.</summary>
internal sealed class PumpHouseException(string message) : Exception(message);
