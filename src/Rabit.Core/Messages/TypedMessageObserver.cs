namespace Rabit.Core.Messages;

/// <summary>The observer of a message of one type: a local copy of its own, made when a value is first read.</summary>
internal sealed class TypedMessageObserver<T>(SharedMessage<T> shared) : MessageObserver(shared.Name, typeof(T))
{
    private LocalCopy<T>? _copy;

    public override MessageStamp ReadStamp() => shared.ReadStamp();

    public override object? ReadValue(out MessageStamp stamp)
    {
        _copy ??= shared.CreateCopy();
        if (shared.Version != _copy.SeenVersion)
            shared.Fetch(_copy);
        stamp = _copy.Stamp;
        return _copy.Value;
    }
}
