using System;

namespace Rabit.Diagnostics.Values;

/// <summary>A public field or property that can be read; <paramref name="Read"/> may run user code.</summary>
internal sealed record ReadableMember(string JsonName, Func<object, object?> Read);
