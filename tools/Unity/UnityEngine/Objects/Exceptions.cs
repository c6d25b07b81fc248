using System;

namespace UnityEngine;

public class UnityException : SystemException
{
    public UnityException()
        : this("A Unity Runtime error occurred!")
    {
    }

    public UnityException(string message)
        : base(message)
    {
    }

    public UnityException(string message, Exception innerException)
        : base(message, innerException)
    {
    }
}

public class MissingReferenceException : SystemException
{
    public MissingReferenceException()
        : this("A Unity Runtime error occurred!")
    {
    }

    public MissingReferenceException(string message)
        : base(message)
    {
    }

    public MissingReferenceException(string message, Exception innerException)
        : base(message, innerException)
    {
    }
}
